//! Traceability of an axis: each parameter with the coefficients that depend on it, and each coefficient with its parameters
//! and with its lines in the emitted files.

use crate::words::made;
use generator::blocks::{Block, Designed};
use generator::config::{ListOptions, Load};
use generator::diagnostics::Report;
use generator::generate::identity;
use generator::number::literal;
use generator::target::{File, Target};
use generator::trace::{self, Traced};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;

/// An axis.
#[derive(Clone, Debug, Serialize)]
pub struct Trace {
    pub axis: String,
    /// all that its blocks use
    pub parameters: Vec<ParameterRow>,
    /// all in the emitted files, by block
    pub coefficients: Vec<CoefficientRow>,
    /// the emitted files
    #[serde(skip)]
    pub files: Vec<File>,
}

/// A parameter.
#[derive(Clone, Debug, Serialize)]
pub struct ParameterRow {
    pub id: Option<&'static str>,
    pub path: String,
    pub value: String,
    pub unit: &'static str,
    pub meaning: &'static str,
    /// where it is given; `null` if it has its default
    pub given: Option<Given>,
    /// the positions among the coefficients of those that depend on it
    pub coefficients: Vec<usize>,
}

/// The place of a value; line and column count from 1.
#[derive(Clone, Debug, Serialize)]
pub struct Given {
    pub file: String,
    pub line: usize,
    pub column: usize,
}

/// A coefficient.
#[derive(Clone, Debug, Serialize)]
pub struct CoefficientRow {
    pub block: &'static str,
    pub path: String,
    pub value: String,
    pub meaning: &'static str,
    /// the positions of the parameters that it depends on
    pub parameters: Vec<usize>,
    pub lines: Vec<Lines>,
}

/// The lines of a file that contain a coefficient, counted from 1.
#[derive(Clone, Debug, Serialize)]
pub struct Lines {
    pub target: &'static str,
    pub file: String,
    pub lines: Vec<usize>,
}

/// A coefficient: its block, and its position among all of the block.
type Leaf = (&'static str, usize);

/// The trace of an axis with these blocks. `path`, `options` and `load` are those with which its set was read.
///
/// # Errors
/// The set cannot be read again.
pub fn trace(
    (path, options, load): (&Path, &ListOptions, Load<'_>),
    designed: &Designed,
    blocks: &[Block],
    targets: &[Target],
) -> Result<Trace, Report> {
    let traced = trace::parameters(path, options, load, &designed.axis.name)?;
    let mut coefficients: BTreeMap<Leaf, CoefficientRow> = BTreeMap::new();
    let mut files = Vec::new();
    for block in blocks {
        for target in targets {
            files.extend(emitted(designed, block, target, &mut coefficients));
        }
    }
    let positions: BTreeMap<Leaf, usize> = coefficients.keys().copied().zip(0..).collect();
    let mut coefficients: Vec<CoefficientRow> = coefficients.into_values().collect();
    let parameters = traced.into_iter().enumerate().map(|(position, of)| {
        let of_block = |(block, leaves): &(&'static str, Vec<usize>)| -> Vec<usize> {
            leaves.iter().filter_map(|leaf| positions.get(&(*block, *leaf)).copied()).collect()
        };
        let changed: Vec<usize> = of.coefficients.iter().flat_map(of_block).collect();
        changed.iter().for_each(|coefficient| coefficients[*coefficient].parameters.push(position));
        row(of, changed)
    });
    let parameters = parameters.collect();
    Ok(Trace { axis: designed.axis.name.clone(), parameters, coefficients, files })
}

fn row(Traced { id, path, value, unit, meaning, given, .. }: Traced, coefficients: Vec<usize>) -> ParameterRow {
    let given = given.map(|place| Given { file: place.file, line: place.line, column: place.column });
    ParameterRow { id, path, value, unit, meaning, given, coefficients }
}

/// Adds the coefficients of a block in the files of a target, which it returns.
fn emitted(
    designed: &Designed,
    block: &Block,
    target: &Target,
    found: &mut BTreeMap<Leaf, CoefficientRow>,
) -> Vec<File> {
    let identity = identity(&designed.axis, block);
    let named = made(target.coefficients(&identity, block));
    let of_block = block.program.block;
    for (leaf, _, constant) in &named {
        found.entry((of_block, *leaf)).or_insert_with(|| CoefficientRow {
            block: of_block,
            path: constant.path.clone(),
            value: literal(constant.value),
            meaning: constant.doc,
            parameters: Vec::new(),
            lines: Vec::new(),
        });
    }
    let leaves: BTreeMap<&str, usize> = named.iter().map(|(leaf, name, _)| (name.as_str(), *leaf)).collect();
    let files = made(target.files(&identity, block));
    for file in &files {
        for (leaf, lines) in lines_of(file, target.comment_marks(), &leaves) {
            let row = found.get_mut(&(of_block, leaf)).expect("trace: each named coefficient has a row");
            row.lines.push(Lines { target: target.name, file: file.name.clone(), lines });
        }
    }
    files
}

/// The lines of a file with names, by coefficient: in the code, or as a comment where a target has the value instead.
fn lines_of(file: &File, comment: [&str; 2], leaves: &BTreeMap<&str, usize>) -> BTreeMap<usize, Vec<usize>> {
    let is_part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    let mut lines: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (number, part) in parts_of(&file.text, comment) {
        let words: Vec<&str> = match part {
            Part::Code(code) => code.split(|letter| !is_part(letter)).collect(),
            Part::Comment(comment) => name_in(comment).into_iter().collect(),
        };
        for leaf in words.into_iter().filter_map(|word| leaves.get(word)) {
            let lines = lines.entry(*leaf).or_default();
            if lines.last() != Some(&number) {
                lines.push(number);
            }
        }
    }
    lines
}

/// The name in a comment that is a name, or a name with its value.
fn name_in(comment: &str) -> Option<&str> {
    let comment = comment.trim();
    let (name, rest) = comment.split_once(' ').unwrap_or((comment, "= "));
    rest.starts_with("= ").then_some(name)
}

/// A part of a line.
enum Part<'t> {
    Code(&'t str),
    Comment(&'t str),
}

/// The parts of a text with the numbers of their lines. A comment without an end mark ends with its line.
fn parts_of<'t>(text: &'t str, [open, close]: [&str; 2]) -> Vec<(usize, Part<'t>)> {
    let mut parts = Vec::new();
    let mut is_comment = false;
    for (number, line) in (1..).zip(text.lines()) {
        let mut rest = line;
        loop {
            let mark = if is_comment { close } else { open };
            let cut = Some(mark).filter(|mark| !mark.is_empty()).and_then(|mark| rest.split_once(mark));
            let (part, after) = cut.map_or((rest, None), |(part, after)| (part, Some(after)));
            parts.push((number, if is_comment { Part::Comment(part) } else { Part::Code(part) }));
            let Some(after) = after else { break };
            (rest, is_comment) = (after, !is_comment);
        }
        is_comment = is_comment && !close.is_empty();
    }
    parts
}
