//! The description of a block in C for calibration tools: a fragment of ASAP2 1.6 without addresses. Where signals lie is in
//! the symbols and offsets; a tool takes the addresses from the linked program.

use super::header::{layout, one_of};
use super::names;
use crate::target::outline::{Member, Outline};
use crate::target::values::{Values, of_signals};
use crate::target::{BlockIdentity, File, TargetBlock, rendered};
use askama::Template;
use compiler::arithmetic;
use compiler::print::Printer;
use compiler::print::c::LANGUAGE;
use compiler::program::{Program, Type, Variable};
use compiler::ranges::Value;
use portable::{Extreme, RealKind};
use std::collections::{BTreeMap, BTreeSet};

#[derive(Template)]
#[template(path = "c/block.a2l")]
struct Description<'a> {
    file: &'a str,
    axis: &'a BlockIdentity,
    block: &'static str,
    prefix: &'a str,
    /// the variables of the firmware: type and name
    symbols: Vec<(String, String)>,
    /// the units by their names
    units: BTreeMap<String, String>,
    tables: Vec<Table>,
    layouts: BTreeSet<&'static str>,
    objects: Vec<Object>,
}

impl Description<'_> {
    /// The names of the objects of each kind that there is.
    fn lists(&self) -> Vec<(&str, Vec<&Object>)> {
        let (set, measured): (Vec<&Object>, Vec<&Object>) = self.objects.iter().partition(|of| of.is_characteristic);
        let lists = [("REF_CHARACTERISTIC", set), ("REF_MEASUREMENT", measured)];
        lists.into_iter().filter(|(_, objects)| !objects.is_empty()).collect()
    }
}

/// The names of the numbers of some signals.
struct Table {
    name: String,
    signals: Vec<String>,
    rows: Vec<(i64, String)>,
}

impl Table {
    /// The least and the greatest of the numbers.
    fn range(&self) -> [f64; 2] {
        let numbers = || self.rows.iter().map(|(number, _)| *number);
        [numbers().min(), numbers().max()].map(|end| whole(end.unwrap_or_default()))
    }
}

/// A signal, a part of the state or a number of a parameter set.
struct Object {
    name: String,
    doc: String,
    ty: &'static str,
    conversion: String,
    range: [String; 2],
    /// the variable of the firmware, and the offset in it [byte]
    place: (String, usize),
    /// whether a tool may write it; a number of a sealed set it only shows
    is_characteristic: bool,
    is_read_only: bool,
}

/// The variables of the firmware: what its names end with, and what they are.
const VARIABLES: [[&str; 2]; 3] = [["in", "inputs"], ["out", "outputs"], ["mem", "state"]];

/// The description of a block.
pub(in crate::target) fn file(axis: &BlockIdentity, block: &TargetBlock<'_>) -> File {
    let program = &*block.program;
    let prefix = names::prefix(axis, program.block);
    let printer = &Printer::new(program, &LANGUAGE, &prefix);
    let outline = &Outline { axis, block, language: &LANGUAGE, printer, next_line: " " };
    let tables: Vec<Table> = of_signals(outline).into_iter().map(|of| table(&prefix, of)).collect();
    let objects = objects(outline, &prefix, &tables);
    let file = format!("{prefix}.a2l");
    let description = Description {
        file: &file,
        axis,
        block: program.block,
        prefix: &prefix,
        symbols: symbols(program, &prefix),
        units: objects.iter().filter_map(|object| unit(&object.doc)).map(|unit| (identifier(&unit), unit)).collect(),
        layouts: objects.iter().filter(|object| object.is_characteristic).map(|object| object.ty).collect(),
        tables,
        objects,
    };
    rendered(&file, "", &description)
}

/// The types and the variables; without the memory of a design, of which nothing is described.
fn symbols(program: &Program, prefix: &str) -> Vec<(String, String)> {
    let described = VARIABLES.iter().filter(|[end, _]| *end != "mem" || program.made.is_none());
    described.map(|[end, of]| (format!("{prefix}_{of}"), format!("{prefix}_{end}"))).collect()
}

fn table(prefix: &str, Values { signals, group, .. }: Values) -> Table {
    let begin = prefix.len() + 1;
    let number = |of: &Member| of.value.parse().expect("a2l: a value of a signal is an integer");
    let row = |of: &Member| (number(of), of.name[begin..].to_owned());
    let name = signals.last().cloned().unwrap_or_default();
    Table { name, signals, rows: group.constants.iter().map(row).collect() }
}

fn objects(outline: &Outline<'_>, prefix: &str, tables: &[Table]) -> Vec<Object> {
    let program = &*outline.block.program;
    let (set, inputs): (Vec<_>, Vec<_>) = program.inputs.iter().partition(|input| program.in_set(input).is_some());
    let is_not_made = |output: &&Variable| program.in_made(output).is_none();
    let outputs = program.outputs.iter().filter(is_not_made).collect();
    // The memory of a design is of no interest: it acts in no cycle.
    let state = program.state.iter().filter(|_| program.made.is_none()).collect();
    let groups = [
        (inputs, outline.inputs(), "in"),
        (outputs, outline.outputs([names::set(outline.axis), String::new()]), "out"),
        (state, outline.parts_of_state(), "mem"),
        (set, outline.set(), "designed"),
    ];
    let of_group = |(variables, members, end)| objects_in(outline, [prefix, end], tables, variables, members);
    groups.into_iter().flat_map(of_group).collect()
}

/// The objects in a variable of the firmware.
fn objects_in(
    outline: &Outline<'_>,
    [prefix, end]: [&str; 2],
    tables: &[Table],
    variables: Vec<&Variable>,
    members: Vec<Member>,
) -> Vec<Object> {
    let program = &*outline.block.program;
    let (symbol, is_in_set) = (format!("{prefix}_{end}"), end == "designed");
    let offsets = layout(variables.iter().map(|of| one_of(of.ty, program.real))).0;
    let object = |((variable, member), offset): ((&Variable, Member), usize)| {
        let table = tables.iter().find(|of| !is_in_set && end != "mem" && of.signals.contains(&member.name));
        let named = table.map(|of| of.name.clone()).or_else(|| unit(&member.doc).as_deref().map(identifier));
        let range = table.map_or_else(|| range(outline, variable, end), Table::range);
        Object {
            name: format!("{symbol}.{}", member.name),
            ty: type_name(variable.ty, program.real),
            conversion: named.map_or_else(|| "NO_COMPU_METHOD".to_owned(), |name| format!("{prefix}.{name}")),
            range: range.map(|value| format!("{value:?}")),
            place: (symbol.clone(), offset),
            is_characteristic: is_in_set || is_tuned(program, variable, end),
            is_read_only: is_in_set,
            doc: text(&member.doc),
        }
    };
    variables.into_iter().zip(members).zip(offsets).map(object).collect()
}

/// Whether the caller tunes the block by an input: a fraction, or one of a design, with the one that starts it.
fn is_tuned(program: &Program, variable: &Variable, end: &str) -> bool {
    end == "in" && (program.made.is_some() || program.is_fraction(variable))
}

/// The possible values: those that are proven, those that the block accepts, else those of the type.
fn range(outline: &Outline<'_>, variable: &Variable, end: &str) -> [f64; 2] {
    let program = &*outline.block.program;
    let all = match (variable.ty, program.real) {
        (Type::Bool, _) => [0.0, 1.0],
        (Type::I32, _) => [f64::from(i32::MIN), f64::from(i32::MAX)],
        (Type::U32, _) => [0.0, f64::from(u32::MAX)],
        (Type::Real, RealKind::F64) => [f64::MIN, f64::MAX],
        (Type::Real, RealKind::F32) => [f64::from(f32::MIN), f64::from(f32::MAX)],
    };
    match end {
        "in" => accepted(outline, variable).unwrap_or(all),
        "out" => proven(outline, variable).map_or(all, |[low, high]| [low.larger(all[0]), high.smaller(all[1])]),
        _ => all,
    }
}

/// The values of an input that the block accepts, from the constants that it is compared with.
fn accepted(outline: &Outline<'_>, variable: &Variable) -> Option<[f64; 2]> {
    let program = &*outline.block.program;
    if variable.ty != Type::Real {
        return None;
    }
    if program.is_fraction(variable) {
        return Some([0.0, 1.0]);
    }
    let constant = |path: &str| arithmetic::wide(program.constants.iter().find(|of| of.path == path)?.value);
    if program.made.is_none() {
        return constant("sample_limit").map(|limit| [-limit, limit]);
    }
    let highest = match variable.path.rsplit('.').next()? {
        "f0" => return Some([constant("lowest_f0")?, constant("highest_f0")?]),
        "q_factor" => return Some([1.0, constant("largest_quality")?]),
        "damping" => 1_f64.next_down(),
        "weight" => constant("weight_limit")?,
        _ => return Some([0.0, constant("set.ipc.limit")?]),
    };
    Some([constant("smallest_ratio")?, highest])
}

/// The proven values of an output.
fn proven(outline: &Outline<'_>, variable: &Variable) -> Option<[f64; 2]> {
    let block = outline.block.block;
    let position = block.program.outputs.iter().position(|output| output.path == variable.path)?;
    match block.shown.outputs[position] {
        Value::Bool(_) => None,
        Value::Whole(numbers) => Some([numbers.low, numbers.high].map(whole)),
        Value::Real(interval) => Some([interval.low, interval.high]),
    }
}

fn type_name(ty: Type, real: RealKind) -> &'static str {
    match (ty, real) {
        (Type::Bool, _) => "UBYTE",
        (Type::I32, _) => "SLONG",
        (Type::U32, _) => "ULONG",
        (Type::Real, RealKind::F64) => "FLOAT64_IEEE",
        (Type::Real, RealKind::F32) => "FLOAT32_IEEE",
    }
}

/// An integer of 32 bits as a real.
#[expect(clippy::cast_precision_loss, reason = "integers of signals have 32 bits")]
fn whole(number: i64) -> f64 {
    number as f64
}

/// The units of signals, without powers of a second.
const UNITS: [&str; 7] = ["um", "0.001 deg", "increments", "Hz", "ns", "cycles", "%"];

/// The unit in a doc comment, which is in square brackets.
fn unit(doc: &str) -> Option<String> {
    let in_brackets = doc.split('[').skip(1).filter_map(|after| Some(after.split_once(']')?.0));
    let is_unit =
        |text: &&str| UNITS.contains(text) || text.split_once("/s").is_some_and(|(of, _)| UNITS.contains(&of));
    in_brackets.filter(is_unit).last().map(str::to_owned)
}

/// A unit as a name: `um/s^2` becomes `um_per_s2`, `0.001 deg` becomes `mdeg`.
fn identifier(unit: &str) -> String {
    unit.replace("0.001 deg", "mdeg").replace('%', "percent").replace('/', "_per_").replace('^', "").replace(' ', "_")
}

/// A text for quotation marks, with the 255 characters that ASAP2 allows: whole words.
fn text(doc: &str) -> String {
    const MOST: usize = 255;
    let text = doc.replace('\\', "/").replace('"', "'");
    let Some((end, _)) = text.char_indices().nth(MOST) else { return text };
    let words = text[..end].rfind(' ').map_or(&text[..end], |space| text[..space].trim_end_matches([',', ';', ':']));
    words.to_owned()
}
