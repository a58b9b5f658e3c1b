//! A program of TwinCAT with its parts: structures, global variables, blocks. Its files are read one after another, each
//! before those that use it. Constructs that occur in a program and not in an emitted block are allowed only here:
//! structures, `VAR_IN_OUT`, process data, and variables of the runtime.

use super::block::Block;
use super::declarations::Declarations;
use super::kind::Kind;
use super::known::{Address, Known, addresses};
use super::mistake::Mistakes;
use super::read::File;
use super::structure::Structure;
use super::syntax::{children, shown};
use super::types::Place;
use super::variables::{Role, Variable, Variables};
use super::{Dialect, Mistake, lexical, syntax, twincat};
use portable::RealKind;
use tree_sitter::Node;

/// The parts of a program that have been read.
#[derive(Clone, Debug)]
pub struct Program {
    real: RealKind,
    structures: Vec<Structure>,
    globals: Variables,
    blocks: Vec<Block>,
}

impl Program {
    /// An empty program; its reals have one type.
    #[must_use]
    pub fn new(real: RealKind) -> Self {
        Self { real, structures: Vec::new(), globals: Variables::new(real), blocks: Vec::new() }
    }

    /// Declares a variable of type UDINT of the controller's runtime, by the text of its uses.
    pub fn runtime(&mut self, text: &str) {
        let slot = self.globals.slot(Kind::Udint, None);
        self.globals.single.add(text, Variable { kind: Kind::Udint, role: Role::Input, slot, known: true });
    }

    /// Reads a `.TcDUT` with structures.
    ///
    /// # Errors
    /// It contains something else, or constructs that implementations may interpret differently.
    pub fn structure(&mut self, file: &str) -> Result<(), Vec<Mistake>> {
        let mut found = Vec::new();
        self.declaration(file, "DUT", |program, node, text, _, mistakes| {
            let place = Place { text, dialect: Dialect::TwinCat, real: program.real, known: program.known() };
            found.extend(place.structure(node, mistakes));
        })?;
        self.structures.append(&mut found);
        Ok(())
    }

    /// Reads a `.TcGVL`: the names of its variables are the name of the list, a dot and their own.
    ///
    /// # Errors
    /// It contains something else, or constructs that implementations may interpret differently.
    pub fn globals(&mut self, file: &str) -> Result<(), Vec<Mistake>> {
        let mut all = self.globals.clone();
        self.declaration(file, "GVL", |program, node, text, (prefix, addresses), mistakes| {
            let known = program.known();
            for (part, _) in children(node).into_iter().filter(|(part, _)| part.kind() == "var_global") {
                let dialect = Dialect::TwinCat;
                Declarations { text, dialect, known, prefix, addresses, all: &mut all, mistakes }.declare(part);
            }
        })?;
        self.globals = all;
        Ok(())
    }

    /// Reads the `.TcPOU` of a block.
    ///
    /// # Errors
    /// It contains constructs that implementations may interpret differently.
    pub fn block(&mut self, file: &str, name: &str) -> Result<(), Vec<Mistake>> {
        let block = self.read(file, name)?;
        self.add(block);
        Ok(())
    }

    /// Adds a block that has been read already.
    pub fn add(&mut self, block: Block) {
        self.blocks.push(block);
    }

    /// Reads the `.TcPOU` of the program itself: it runs like a block whose variables are those of the program and the
    /// global ones.
    ///
    /// # Errors
    /// It contains constructs that implementations may interpret differently.
    pub fn read(&self, file: &str, name: &str) -> Result<Block, Vec<Mistake>> {
        let mut source = twincat::read(file)?;
        let addresses = addresses(&mut source.text);
        let (dialect, real, known) = (Dialect::TwinCat, self.real, self.known());
        Block::of_source(file, &File { source: &source, dialect, real, known, addresses: &addresses }, name)
    }

    fn known(&self) -> Known<'_> {
        Known { blocks: &self.blocks, structures: &self.structures, globals: Some(&self.globals), is_program: true }
    }

    /// Reads the declarations of a file.
    fn declaration(
        &self,
        file: &str,
        element: &str,
        mut each: impl FnMut(&Self, Node<'_>, &str, (&str, &[Address]), &mut Mistakes<'_>),
    ) -> Result<(), Vec<Mistake>> {
        let (mut source, name) = twincat::declaration(file, element)?;
        // The grammar requires a semicolon there; TwinCAT's own files have none.
        source.text = source.text.replace("END_STRUCT\n", "END_STRUCT;");
        let addresses = addresses(&mut source.text);
        let mut mistakes = Mistakes::new(&source, file);
        let letters = lexical::check(Dialect::TwinCat, &source.text, &mut mistakes);
        let tree = syntax::parse(&source.text[..letters.end]);
        if let Some(tree) = &tree {
            syntax::check(tree, &source.text, &letters, &mut mistakes);
            for (node, _) in children(tree.root_node()) {
                match node.kind() {
                    "type_declaration" | "global_var_declaration_block" => {
                        each(self, node, &source.text, (&format!("{name}."), &addresses), &mut mistakes);
                    }
                    "pragma" | "ERROR" => {}
                    _ => mistakes.push(node.start_byte(), shown(node, &source.text), "declarations"),
                }
            }
        } else {
            mistakes.push(0, "a text that is not Structured Text", "declarations");
        }
        let mistakes = mistakes.sorted();
        if mistakes.is_empty() { Ok(()) } else { Err(mistakes) }
    }
}

impl Block {
    /// Reads the block of a `.TcPOU` with an input whose type is declared in a `.TcDUT`.
    ///
    /// # Errors
    /// A file contains constructs outside the portable subset, or there is no such block.
    pub fn read_typed(text: &str, types: &str, name: &str, real: RealKind) -> Result<Self, Vec<Mistake>> {
        let mut program = Program::new(real);
        program.structure(types)?;
        let source = twincat::read(text)?;
        let known = Known { structures: &program.structures, ..Known::default() };
        let file = File { source: &source, dialect: Dialect::TwinCat, real, known, addresses: &[] };
        Self::of_source(text, &file, name)
    }
}
