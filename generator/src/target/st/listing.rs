//! A block in the notation of a dialect, and the comment at the top of its file.

use super::dialect::Dialect;
use crate::blocks::IPC;
use crate::target::outline::{COMMENT_WIDTH, Group, Member, Outline};
use crate::target::{BlockIdentity, TargetBlock, block_name};
use askama::Template;
use compiler::print::{Appearance, Printer, comment};
use compiler::program::Type;

/// The input that is a parameter set.
pub(super) const SET: &str = "params";

/// The comment at the top of a file.
#[derive(Template)]
#[template(path = "st/origin.st")]
pub(super) struct Origin<'a> {
    pub(super) file: &'a str,
    axis: &'a BlockIdentity,
    block: &'static str,
    real: &'a str,
    /// what the block is for, and what its first call does
    purpose: String,
    /// when its caller calls it
    rate: &'static str,
    /// the proven range of the block, and its measured response
    certificate: String,
    /// an instance with its type
    instance: [String; 2],
    /// the declaration of its parameter set; empty if it takes none
    set: String,
    /// the arguments of a call
    arguments: Vec<String>,
}

/// A block: declarations, numbers, statements.
#[derive(Clone, Debug)]
pub(in crate::target) struct Listing {
    pub(super) name: String,
    /// quotes around the names of types that the language does not define
    pub(super) quote: &'static str,
    pub(super) inputs: Vec<Member>,
    /// the type of its parameter set, if it takes one
    pub(super) set: Option<SetType>,
    pub(super) outputs: Vec<Member>,
    pub(super) state: Vec<Member>,
    pub(super) locals: Vec<Member>,
    /// numbers that are written in the statements
    pub(super) inline: Vec<Group>,
    /// numbers that are declared
    pub(super) declared: Vec<Group>,
    /// numbers that are assigned again in each cycle
    pub(super) assigned: Vec<Group>,
    pub(super) body: String,
}

/// The structure of a parameter set.
#[derive(Clone, Debug)]
pub(in crate::target) struct SetType {
    pub(super) name: String,
    /// empty if another block of the axis declares it
    pub(super) parts: Vec<Member>,
}

/// The name of the type of the parameter sets of an axis.
pub(crate) fn set_name(axis: &str) -> String {
    format!("ST_{}_params", block_name(axis, IPC))
}

impl Listing {
    /// The type of its set if its file declares it.
    pub(super) fn declared_set(&self) -> Option<&SetType> {
        self.set.as_ref().filter(|set| !set.parts.is_empty())
    }

    /// The name of the type of its set, in a declaration.
    pub(super) fn set_name(&self, set: &SetType) -> String {
        format!("{0}{1}{0}", self.quote, set.name)
    }

    /// Whether it has an input of this name.
    pub(super) fn has_input(&self, name: &str) -> bool {
        self.inputs.iter().any(|input| input.name == name)
    }

    /// Whether it has an output of this name.
    pub(super) fn has_output(&self, name: &str) -> bool {
        self.outputs.iter().any(|output| output.name == name)
    }

    /// Whether an input has a start value other than 0 or FALSE.
    pub(super) fn starts_inputs(&self) -> bool {
        self.inputs.iter().any(|input| !["", "0", "0.0", "FALSE"].contains(&&*input.value))
    }

    /// Whether a variable is an instance of another block.
    pub(super) fn is_block(&self, member: &Member) -> bool {
        !["BOOL", "DINT", "UDINT", "REAL", "LREAL"].contains(&&*member.ty) && self.array(member).is_none()
    }

    /// The index of the last element of an array, and the type of its elements.
    pub(super) fn array<'m>(&self, member: &'m Member) -> Option<(&'m str, &'m str)> {
        member.ty.strip_prefix("ARRAY[0..")?.split_once("] OF ")
    }
}

/// The type of the parameter sets of an axis, as in a declaration.
pub(super) fn made(axis: &BlockIdentity, dialect: &Dialect) -> String {
    format!("{0}{1}{0}", dialect.quote, set_name(&axis.name))
}

/// The name of the function block of a block of an axis.
pub(super) fn name(axis: &str, block: &str, dialect: &Dialect) -> String {
    format!("{}{}", dialect.prefix, block_name(axis, block))
}

pub(super) fn listing(axis: &BlockIdentity, block: &TargetBlock<'_>, dialect: &Dialect) -> Listing {
    let printer = &Printer::new(&block.program, dialect.language, "");
    let outline = Outline { axis, block, language: dialect.language, printer, next_line: "\n       " };
    let [inline, declared, assigned] = outline.groups([Appearance::Inline, Appearance::Declared, Appearance::Assigned]);
    Listing {
        name: name(&axis.name, block.program.block, dialect),
        quote: dialect.quote,
        inputs: outline.inputs(),
        set: block.program.has_set().then(|| SetType {
            name: set_name(&axis.name),
            parts: if block.block.shares_set() { Vec::new() } else { outline.set() },
        }),
        outputs: outline.outputs([made(axis, dialect), String::new()]),
        state: outline.state(outline.parts_of_state(), |of, length| Member {
            ty: format!("ARRAY[0..{}] OF {}", length - 1, of.ty).into(),
            ..of
        }),
        locals: outline.locals(),
        inline,
        declared,
        assigned,
        body: printer.body(&block.program.step, 0),
    }
}

/// The comment at the top of a file that belongs to a block.
pub(super) fn origin<'a>(
    axis: &'a BlockIdentity,
    file: &'a str,
    block: &TargetBlock<'_>,
    dialect: &Dialect,
) -> Origin<'a> {
    Origin {
        file,
        axis,
        block: block.program.block,
        real: dialect.language.ty(Type::Real, axis.real),
        purpose: String::new(),
        rate: block.rate(),
        certificate: String::new(),
        instance: Default::default(),
        set: String::new(),
        arguments: Vec::new(),
    }
}

impl Origin<'_> {
    /// Adds the comment of the file that holds the block itself: its purpose, its guaranteed range, and how to call it.
    pub(super) fn with_call(self, block: &TargetBlock<'_>, listing: &Listing, dialect: &Dialect) -> Self {
        let [mode, cycle, counter] = dialect.arguments;
        let argument = |input: &str| match input {
            "Enable" => format!("{input} := TRUE"),
            "mode" => format!("{input} := {mode}"),
            "task_cycle_ns" => format!("{input} := {cycle}"),
            "cycle_counter" => format!("{input} := {counter}"),
            other => format!("{input} := {}{other}", dialect.mark),
        };
        let mut arguments: Vec<String> = listing.inputs.iter().map(|input| argument(&input.name)).collect();
        arguments.extend(listing.set.is_some().then(|| format!("{0} := {1}{0}{1}", SET, dialect.quote)));
        let instance = format!("{}_{}", self.axis.name.to_ascii_lowercase(), self.block);
        let ty = format!("{0}{1}{0}", dialect.quote, name(&self.axis.name, self.block, dialect));
        // In SCL the set is a data block, to which `params-of` writes.
        let set = set_name(&self.axis.name);
        let set = match dialect.quote {
            "" => format!("{SET} : {set};"),
            quote => format!("a data block {quote}{SET}{quote} of the type {quote}{set}{quote}"),
        };
        Self {
            purpose: comment::wrapped(&[&block.block.purpose], COMMENT_WIDTH, "\n   "),
            certificate: comment::wrapped(&block.block.certificate.lines, COMMENT_WIDTH, "\n   "),
            instance: [format!("{}{instance}", dialect.mark), format!("{instance} : {ty}")],
            set: if block.program.has_set() { set } else { String::new() },
            arguments,
            ..self
        }
    }
}
