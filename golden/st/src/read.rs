//! A file -> a function block that can run, or all its errors.

use super::block::Block;
use super::declarations::Declarations;
use super::kind::Kind;
use super::known::{Address, Known};
use super::lowering::Lowering;
use super::mistake::{Lines, Mistakes};
use super::source::Source;
use super::structure::Structure;
use super::syntax::{children, said, shown};
use super::types::Place;
use super::variables::Variables;
use super::{Dialect, Mistake, lexical, names, plcopen, scl, syntax, twincat};
use portable::RealKind;
use std::collections::BTreeSet;
use tree_sitter::{Node, Tree};

/// A longer text is not one of axgen's; the parser counts bytes in 32 bits.
const LONGEST: usize = 1 << 28;

impl Block {
    /// Reads the block `name` of a file with reals of one type. All blocks of the file are checked.
    ///
    /// # Errors
    /// The file contains constructs outside the portable subset, or there is no such block.
    pub fn read(dialect: Dialect, text: &str, name: &str, real: RealKind) -> Result<Self, Vec<Mistake>> {
        Self::read_with(dialect, text, name, real, &[])
    }

    /// Reads the block `name` of a file whose blocks may have instances of `others`, which come from other files.
    ///
    /// # Errors
    /// The file contains constructs outside the portable subset, or there is no such block.
    pub fn read_with(
        dialect: Dialect,
        text: &str,
        name: &str,
        real: RealKind,
        others: &[Self],
    ) -> Result<Self, Vec<Mistake>> {
        if text.len() > LONGEST {
            return Err(vec![Lines::new("").mistake(0, format!("{} bytes", text.len()), "a shorter file")]);
        }
        let source = match dialect {
            Dialect::Plain => Source::plain(text),
            Dialect::TwinCat => twincat::read(text)?,
            Dialect::Codesys => plcopen::read(text)?,
            Dialect::Scl => scl::read(text)?,
        };
        // Structures passed to an instance have the types that its own file declares.
        let structures: Vec<Structure> = others.iter().flat_map(|other| other.structures.clone()).collect();
        let known = Known { blocks: others, structures: &structures, ..Known::default() };
        Self::of_source(text, &File { source: &source, dialect, real, known, addresses: &[] }, name)
    }

    /// Reads a block of a text that was taken out of its file.
    pub(crate) fn of_source(text: &str, file: &File<'_>, name: &str) -> Result<Self, Vec<Mistake>> {
        let &File { source, dialect, .. } = file;
        let mut mistakes = Mistakes::new(source, text);
        let letters = lexical::check(dialect, &source.text, &mut mistakes);
        let Some(tree) = syntax::parse(&source.text[..letters.end]) else {
            mistakes.push(0, "a text that is not Structured Text", "declarations and statements");
            return Err(mistakes.sorted());
        };
        syntax::check(&tree, &source.text, &letters, &mut mistakes);
        syntax::signs(&tree, &source.text, &mut mistakes);
        let blocks = blocks(&tree, file, &mut mistakes);
        let found = blocks.into_iter().find(|block| block.name.eq_ignore_ascii_case(name));
        let broken = tree.root_node().has_error();
        if broken && mistakes.is_empty() {
            mistakes.push(0, "a text that is not Structured Text", "declarations and statements");
        }
        if found.is_none() && !broken {
            mistakes.push(0, format!("no block `{name}`"), format!("`FUNCTION_BLOCK {name}`"));
        }
        match found {
            Some(mut block) if mistakes.is_empty() => {
                block.place = Lines::new(text).place(source.origin(block.place.0));
                Ok(block)
            }
            _ => Err(mistakes.sorted()),
        }
    }
}

/// The data for reading a text.
pub(crate) struct File<'a> {
    /// its text
    pub(crate) source: &'a Source,
    /// its form
    pub(crate) dialect: Dialect,
    /// the type of its reals
    pub(crate) real: RealKind,
    /// declarations of other files
    pub(crate) known: Known<'a>,
    /// its process data
    pub(crate) addresses: &'a [Address],
}

/// All blocks of a text; their places are still bytes of the text.
fn blocks(tree: &Tree, file: &File<'_>, mistakes: &mut Mistakes<'_>) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut structures = file.known.structures.to_vec();
    for (node, _) in children(tree.root_node()) {
        let known = Known { structures: &structures, ..file.known };
        let file = &File { known, ..*file };
        match node.kind() {
            "type_declaration" if !file.known.is_program => {
                let &File { source, dialect, real, known, .. } = file;
                let found = Place { text: &source.text, dialect, real, known }.structure(node, mistakes);
                structures.extend(found);
            }
            "function_block_declaration" => {
                let block = block(node, file, mistakes);
                if blocks.iter().any(|other| other.name.eq_ignore_ascii_case(&block.name)) {
                    mistakes.push(node.start_byte(), format!("a second block `{}`", block.name), "another name");
                }
                blocks.push(block);
            }
            "program_declaration" if file.known.is_program => blocks.push(block(node, file, mistakes)),
            "pragma" | "ERROR" => {}
            ";" => mistakes.push(node.start_byte(), "`;` without a statement", "nothing"),
            _ => mistakes.push(node.start_byte(), shown(node, &file.source.text), "`FUNCTION_BLOCK`"),
        }
    }
    blocks
}

fn validate_name(name: &str, at: usize, file: &File<'_>, mistakes: &mut Mistakes<'_>) {
    if let Some((found, instead)) = names::mistake(file.dialect, name) {
        mistakes.push(at, found, instead);
    }
    if let Some(outside) = file.source.name.as_ref().filter(|outside| *outside != name) {
        mistakes.push(at, format!("the block `{name}` in the file of `{outside}`"), "one name in both places");
    }
}

fn block(node: Node<'_>, file: &File<'_>, mistakes: &mut Mistakes<'_>) -> Block {
    let &File { source, dialect, real, known, addresses } = file;
    let text = source.text.as_str();
    // Only the program uses global variables: a block and its caller never have two names for one variable.
    let globals = known.globals.filter(|_| node.kind() == "program_declaration").cloned();
    let (mut variables, mut body) = (globals.unwrap_or_else(|| Variables::new(real)), Vec::new());
    // Ensures that a wrong condition has a slot too.
    variables.slot(Kind::Bool, None);
    let (mut name, mut place, mut all_declared) = (String::new(), node, true);
    for (part, field) in children(node) {
        let at = part.start_byte();
        let misplaced = |inside: bool| source.body.is_some_and(|body| (at >= body) == inside);
        match (part.kind(), field) {
            ("identifier", Some("name")) => {
                said(part, text).clone_into(&mut name);
                place = part;
                validate_name(&name, at, file, mistakes);
            }
            (kind, _) if kind.starts_with("var_") => {
                if misplaced(true) {
                    mistakes.push(at, "a `VAR` block in the body", "the `VAR` block in the declaration");
                }
                all_declared &= !part.has_error();
                let (all, mistakes) = (&mut variables, &mut *mistakes);
                Declarations { text, dialect, known, prefix: "", addresses, all, mistakes }.declare(part);
            }
            ("method_declaration" | "property_declaration", _) => {
                mistakes.push(at, shown(part, text), "one body");
            }
            (word @ ("ABSTRACT" | "FINAL" | "EXTENDS" | "IMPLEMENTS"), None) => {
                mistakes.push(at, format!("`{word}`"), "a block by itself");
            }
            (_, Some("extends" | "implements"))
            | ("ABSTRACT" | "FINAL" | "EXTENDS" | "IMPLEMENTS", _)
            | ("FUNCTION_BLOCK" | "END_FUNCTION_BLOCK" | "PROGRAM" | "END_PROGRAM", _) => {}
            _ => {
                if misplaced(false) {
                    mistakes.push(at, "a statement in the declaration", "the statement in the body");
                }
                body.push(part);
            }
        }
    }
    let mut lowering = Lowering {
        text,
        dialect,
        known,
        variables: &mut variables,
        mistakes,
        ops: Vec::new(),
        assignments: Vec::new(),
        assigned: BTreeSet::new(),
        depth: 0,
        too_deep: false,
        all_declared,
    };
    lowering.statements(&body, place, "a body");
    let (ops, assignments) = (lowering.ops, lowering.assignments);
    Block { name, variables, structures: known.structures.to_vec(), ops, assignments, place: (place.start_byte(), 0) }
}
