//! The target languages: each turns verified programs into files. A target never looks at a parameter.

mod c;
mod called;
pub mod head;
mod outline;
mod rust;
mod st;
mod unit;
mod values;

pub(crate) use c::names::prefix as c_prefix;
pub use called::of_names;
pub(crate) use st::listing::set_name as st_set_name;
pub use st::meanings;
pub use st::twincat::{Cdata, guid};

use crate::blocks::Block;
use crate::digest::with_checksum;
use crate::exercise::runner::Runner;
use askama::Template;
use compiler::legalise;
use compiler::pass::{Defect, Stage};
use compiler::print::{self, Language, Printer};
use compiler::program::{Constant, Origin, Program};
use portable::{Literal, RealKind};
use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::BTreeSet;

/// The tool's version, which every generated file names.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The licence statement in the head of a generated file.
pub(crate) const LICENCE: &str = "this file belongs to the user of axgen; no licence of axgen applies to it";

/// The folders that files lie in, below the output folder: itself, the crate of Rust, and those of TwinCAT.
pub const FOLDERS: [&str; 6] = ["", "rust/", "twincat/", "twincat/DUTs/", "twincat/POUs/", "twincat/Tests/"];

#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// the name on the command line and in a set
    pub name: &'static str,
    /// the passes that make a program expressible in the language
    pub passes: &'static [Stage],
    language: &'static Language,
    /// the names of a block of an axis and of its self-test
    called: fn(&str, &str, bool) -> [String; 2],
    /// the files of a block after these passes
    pub(crate) files: fn(&BlockIdentity, &TargetBlock<'_>) -> Vec<File>,
    /// the files that all axes of a set share
    pub shared: fn(&[Unit<'_>]) -> Vec<File>,
    /// the file of a block's runner; not every language has one
    runner: Option<fn(&BlockIdentity, &TargetBlock<'_>, &Runner) -> File>,
    /// number of samples of the runner written with each block; `None`: no runner
    samples: Option<usize>,
    /// the file of a block's description for calibration tools; not every language has one
    description: Option<fn(&BlockIdentity, &TargetBlock<'_>) -> File>,
    /// whether it is written
    is_described: bool,
}

pub const TARGETS: [Target; 6] = [
    Target {
        runner: Some(c::runner::file),
        description: Some(c::a2l::file),
        ..target("c", legalise::WITH_OUTPUTS, &print::c::LANGUAGE, c::names::block_and_test, c::files, |_| Vec::new())
    },
    target("rust", legalise::WITH_OUTPUTS, &print::rust::LANGUAGE, rust::called, rust::files, rust::library::shared),
    target("st", legalise::WITH_DIGITS, &print::st::PLAIN, st::called, st::plain, |_| Vec::new()),
    target(
        "twincat",
        legalise::WITH_TASK,
        &print::st::CODESYS,
        st::twincat::called,
        st::twincat::files,
        st::twincat::shared,
    ),
    target(
        "codesys",
        legalise::WITH_ENABLE,
        &print::st::CODESYS,
        st::codesys::called,
        st::codesys::files,
        st::codesys::shared,
    ),
    target("scl", legalise::WITH_NAMES, &print::st::SCL, st::scl_called, st::scl, st::scl_shared),
];

/// A target without runners and descriptions.
const fn target(
    name: &'static str,
    passes: &'static [Stage],
    language: &'static Language,
    called: fn(&str, &str, bool) -> [String; 2],
    files: fn(&BlockIdentity, &TargetBlock<'_>) -> Vec<File>,
    shared: fn(&[Unit<'_>]) -> Vec<File>,
) -> Target {
    let (runner, samples, description) = (None, None, None);
    Target { name, passes, language, called, files, shared, runner, samples, description, is_described: false }
}

/// The targets of a set that names none.
pub const DEFAULT_TARGETS: [&str; 2] = ["c", "st"];

pub fn named(name: &str) -> Option<Target> {
    TARGETS.into_iter().find(|target| target.name == name)
}

impl Target {
    /// The program of a block in a form that the language can express.
    ///
    /// # Errors
    /// A defect of a legalising pass.
    pub fn program<'b>(&self, block: &'b Block) -> Result<Cow<'b, Program>, Defect> {
        legalise::run(&block.for_axis.program, self.passes)
    }

    /// A block with that program.
    ///
    /// # Errors
    /// A defect of a legalising pass.
    pub fn block<'b>(&self, block: &'b Block) -> Result<TargetBlock<'b>, Defect> {
        Ok(TargetBlock { program: self.program(block)?, block, in_codesys: OnceCell::new() })
    }

    /// The names of the passes that change the program of a block: targets with the same passes have the same program.
    pub(crate) fn passes_of(&self, block: &Block) -> Vec<&'static str> {
        legalise::needed(&block.for_axis.program, self.passes).iter().map(|(name, _)| *name).collect()
    }

    /// The files of a block.
    ///
    /// # Errors
    /// A defect of a legalising pass.
    pub fn files(&self, identity: &BlockIdentity, block: &Block) -> Result<Vec<File>, Defect> {
        Ok((self.files)(identity, &self.block(block)?))
    }

    /// The coefficients in the text of a block: the position of each among all of the block, its name in the files, and the
    /// constant.
    ///
    /// # Errors
    /// A defect of a legalising pass.
    pub fn coefficients(
        &self,
        identity: &BlockIdentity,
        block: &Block,
    ) -> Result<Vec<(usize, String, Constant)>, Defect> {
        let program = self.program(block)?;
        // C has one space of names for what is outside of functions.
        let prefix = if self.name == "c" { c_prefix(identity, program.block) } else { String::new() };
        let printer = Printer::new(&program, self.language, &prefix);
        let named = program.constants.iter().zip(&printer.names().constants).filter_map(|(constant, name)| {
            let Origin::Coefficient(leaf) = constant.origin else { return None };
            Some((leaf, name.clone(), constant.clone()))
        });
        Ok(named.collect())
    }

    /// The marks at the beginning and at the end of a comment; without the latter, a comment ends with its line.
    #[must_use]
    pub fn comment_marks(&self) -> [&'static str; 2] {
        self.language.comment_marks()
    }

    /// The target with a runner of this number of samples for each block, if the language has runners.
    #[must_use]
    pub fn with_runners(self, samples: usize) -> Option<Self> {
        self.runner.map(|_| Self { samples: Some(samples), ..self })
    }

    /// The target with a description of each block, if the language has them.
    #[must_use]
    pub fn with_descriptions(self) -> Option<Self> {
        self.description.map(|_| Self { is_described: true, ..self })
    }

    /// The file of a block's description, if requested.
    pub fn description(&self, identity: &BlockIdentity, block: &TargetBlock<'_>) -> Option<File> {
        Some(self.description.filter(|_| self.is_described)?(identity, block))
    }

    /// The file of a block's runner, if requested; `record` runs the reference for the given number of samples.
    pub fn runner(
        &self,
        identity: &BlockIdentity,
        block: &TargetBlock<'_>,
        record: impl FnOnce(usize) -> Runner,
    ) -> Option<File> {
        Some((self.runner?)(identity, block, &record(self.samples?)))
    }
}

/// The facts about an axis and a block in the head of a file.
#[derive(Clone, Debug)]
pub struct BlockIdentity {
    pub name: String,
    pub real: RealKind,
    /// whether the axis uses short names in C
    pub short_names: bool,
    /// the cycle of its position controller
    pub cycle_time_ns: u32,
    /// whether it is a rotary axis or a spindle: its signals are in 0.001 deg, else in um
    pub is_rotary: bool,
    /// the digest of the effective parameters of the block
    pub parameters_digest: String,
    /// the digest of what is in the block, without the values of its coefficients
    pub structure_digest: String,
}

/// A block with its program in a form that the language of a target can express.
#[derive(Clone, Debug)]
pub struct TargetBlock<'b> {
    block: &'b Block,
    program: Cow<'b, Program>,
    /// the block and its self-test in the notation of TwinCAT and CODESYS, once one of them prints it
    in_codesys: OnceCell<[st::Listing; 2]>,
}

impl TargetBlock<'_> {
    /// When its caller calls it, for comments.
    fn rate(&self) -> &'static str {
        match self.program.made {
            Some(_) => "in a slow task, once or several times per cycle",
            None => "once per position-controller cycle",
        }
    }

    /// What the name of an input is, by its position among all, where the language has the inputs of the axis as they are.
    fn input<'n>(&self, names: &'n [String], position: usize) -> &'n str {
        let own = self.block.for_axis.inputs.iter().position(|kept| *kept == position);
        &names[own.expect("target: an exercise knows the inputs that the axis has")]
    }

    /// The inputs other than reals, with their usual values, except for a counter.
    fn usual<'n>(&self, names: &'n [String], literal: fn(Literal) -> String) -> Vec<(&'n str, String)> {
        let exercise = &self.block.exercise;
        let usual = exercise.switches.iter().map(|(input, _)| *input).filter(|at| Some(*at) != exercise.counter());
        usual.map(|at| (self.input(names, at), literal(exercise.usual[at]))).collect()
    }
}

/// The facts about an axis that a shared file may use: none that changes with a parameter other than the real type.
#[derive(Clone, Debug)]
pub struct Unit<'a> {
    pub axis: &'a str,
    /// the real types of its blocks
    pub reals: BTreeSet<RealKind>,
    /// the names of its blocks
    pub blocks: Vec<&'static str>,
    /// whether it takes parameter sets, whose type other blocks use
    pub takes_sets: bool,
}

/// A file that was made, with its name below the output folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// the name; folders are separated by `/`
    pub name: String,
    pub text: String,
}

/// The beginning of all names of an axis.
pub fn stem(axis: &str) -> String {
    format!("axis_{}", axis.to_ascii_lowercase())
}

/// The name of a block of an axis in every target, apart from a prefix.
pub fn block_name(axis: &str, block: &str) -> String {
    format!("{}_{block}", stem(axis))
}

/// A block with a separately named self-test.
fn with_self_test(block: String) -> [String; 2] {
    let test = format!("{block}_self_test");
    [block, test]
}

/// The size of a real [bit].
fn bits(real: RealKind) -> usize {
    match real {
        RealKind::F64 => 64,
        RealKind::F32 => 32,
    }
}

/// A file from its template; `mark` precedes it, for readers that need a byte order mark.
pub(crate) fn rendered(name: &str, mark: &str, template: &impl Template) -> File {
    let mut text = template.render().expect("target: no input can keep a template from being filled");
    text.insert_str(0, mark);
    text.push('\n');
    File { name: name.to_owned(), text: with_checksum(text) }
}
