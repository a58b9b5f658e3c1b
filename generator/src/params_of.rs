//! A parameter set of an axis as text or bytes, for the block that was generated from another version of the axis. The list
//! of its numbers is that of the program from which the block is printed. No file is read here.

use crate::blocks::{self, Block, Designed, IPC};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::generate;
use crate::number::digits;
use crate::set_change::{Refusal, judge};
use crate::target::{BlockIdentity, block_name, c_prefix, rendered, st_set_name};
use askama::Template;
use compiler::pass::Defect;
use compiler::print::{Language, c, rust, signals, st};
use portable::Literal;

/// The first four bytes of a set in the form `bin`.
pub const BIN_MAGIC: [u8; 4] = *b"AXPS";
/// The version of that form.
pub const BIN_VERSION: u32 = 1;

/// The form of a parameter set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// a constant in C, of the struct of the block's header
    C,
    /// a constant in Rust, of the struct of the block's module
    Rust,
    /// assignments in Structured Text: TwinCAT, CODESYS, any compiler of the standard's second edition
    St,
    /// assignments in Structured Text for a data block of an S7-1500
    Scl,
    /// a line `name,value` for each member
    Csv,
    /// [`BIN_MAGIC`], [`BIN_VERSION`], the length of the struct in C, and its bytes, all little-endian
    Bin,
}

impl Form {
    /// All forms, by their names on the command line.
    pub const ALL: [(&str, Self); 6] = [
        ("c", Self::C),
        ("rust", Self::Rust),
        ("st", Self::St),
        ("scl", Self::Scl),
        ("csv", Self::Csv),
        ("bin", Self::Bin),
    ];

    /// The form of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, form)| form)
    }
}

/// Checks a set of `new` on the block that was generated from `old`: reasons against it, and changes that the set does not
/// contain. `files` are the two files, that of `new` first.
pub fn check(new: &Designed, old: &Designed, files: [&str; 2]) -> Report {
    let ([file, on], name) = (files, &new.axis.name);
    let judgement = judge(old, new);
    let mut report = Report::default();
    match &judgement.refused {
        None => {
            for left in &judgement.left {
                let found = format!("axis {name}: {left}: no parameter set says that");
                let warning = Diagnostic::warning(codes::NOT_IN_SET, Place::whole(file), found);
                report.push(
                    warning.instead(format!("`axgen generate {file} --axis {name}`, where the block is to have it")),
                );
            }
        }
        Some(refusal) => report.push(refused(refusal, name, file, on)),
    }
    report
}

/// The reason why the block does not take over the set, for the user.
fn refused(refusal: &Refusal, name: &str, file: &str, on: &str) -> Diagnostic {
    let anew = format!("`axgen generate {file} --axis {name}`: the axis needs a new block");
    match refusal {
        Refusal::NoSetsBefore | Refusal::NoSetsAfter => {
            let place = if *refusal == Refusal::NoSetsBefore { on } else { file };
            let found = format!("axis {name} takes no parameter sets");
            Diagnostic::error(codes::NO_SETS, Place::whole(place), found)
                .allowed(format!("`tunable = \"all\"` or `\"parameters\"`, in {file} and in {on}"))
                .instead(format!("tunable = \"all\" in [axis.{name}], and generate its block again"))
        }
        Refusal::Structure(lines) => {
            let lines = lines.join("; ");
            let found =
                format!("axis {name} has another structure than the block that was generated from {on}: {lines}");
            Diagnostic::error(codes::OTHER_STRUCTURE, Place::whole(file), found)
                .allowed("other weights, frequencies, quality factors and damping, and a smaller limit")
                .instead(anew)
        }
        Refusal::Limit(limits) => {
            let [block, set] = limits.map(digits);
            let found =
                format!("axis {name} has the limit {set}, above the one of the block that was generated from {on}");
            Diagnostic::error(codes::SET_REFUSED, Place::whole(file), found)
                .allowed(format!("limit <= {block}"))
                .instead(format!("a smaller v_add_max_fact (P-AXIS-00757), or {anew}"))
        }
        Refusal::Numbers(id) => {
            let found =
                format!("the block that was generated from {on} refuses the numbers of axis {name} with error_id {id}");
            Diagnostic::error(codes::SET_REFUSED, Place::whole(file), found)
                .allowed(format!("what `axgen explain {id}` says"))
                .instead(anew)
        }
    }
}

/// The members of an axis's parameter set, by their names in C, in the order of the struct. Empty if the axis takes no sets.
///
/// # Errors
/// A defect of the block or of a pass.
pub fn numbers(designed: &Designed) -> Result<Vec<(String, Literal)>, Defect> {
    Ok(block(designed)?.map_or_else(Vec::new, |block| members(&block, &c::LANGUAGE)))
}

/// The set in a form.
///
/// # Errors
/// A defect of the block, of a pass, or of a target.
pub fn bytes(designed: &Designed, form: Form) -> Result<Vec<u8>, Defect> {
    let Some(block) = block(designed)? else { return Ok(Vec::new()) };
    let axis = generate::identity(&designed.axis, &block);
    Ok(match form {
        Form::C => {
            let of = listed(designed, &axis, &block, &c::LANGUAGE, names_in_c(&axis, &block, designed.sets[1]), "c");
            rendered(&of.file, "", &CSet { of: &of }).text.into_bytes()
        }
        Form::Rust => {
            let name = format!("SET_{:08X}", designed.sets[1]);
            let of = listed(designed, &axis, &block, &rust::LANGUAGE, [in_all(&axis, &block), name], "rs");
            rendered(&of.file, "", &RustSet { of: &of }).text.into_bytes()
        }
        Form::St | Form::Scl => {
            let stem = in_all(&axis, &block);
            let ty = st_set_name(&axis.name);
            let (variable, kind, ty, end) = match form {
                Form::Scl => ("\"params\"", "data block", format!("\"{ty}\""), "scl"),
                _ => ("params", "variable", ty, "st"),
            };
            let of = listed(designed, &axis, &block, &st::PLAIN, [stem, ty], end);
            rendered(&of.file, "", &StSet { of: &of, variable, kind }).text.into_bytes()
        }
        Form::Csv => members(&block, &c::LANGUAGE).iter().flat_map(|member| line(member).into_bytes()).collect(),
        Form::Bin => {
            let members = members(&block, &c::LANGUAGE);
            let bytes: Vec<u8> = members.into_iter().flat_map(|(_, value)| little_endian(value)).collect();
            let length = u32::try_from(bytes.len())
                .map_err(|_| Defect { pass: "params_of", message: "a set of more than 4 GB".to_owned() })?;
            [&BIN_MAGIC[..], &BIN_VERSION.to_le_bytes(), &length.to_le_bytes(), &bytes].concat()
        }
    })
}

#[derive(Template)]
#[template(path = "params/set.c")]
struct CSet<'a> {
    of: &'a Listed<'a>,
}

#[derive(Template)]
#[template(path = "params/set.rs")]
struct RustSet<'a> {
    of: &'a Listed<'a>,
}

#[derive(Template)]
#[template(path = "params/set.st")]
struct StSet<'a> {
    of: &'a Listed<'a>,
    /// the variable for the assignments
    variable: &'a str,
    /// the kind of the variable
    kind: &'a str,
}

/// A set in a language.
struct Listed<'a> {
    axis: &'a BlockIdentity,
    file: String,
    /// beginning of the names of the block
    block: String,
    /// name of the constant; in Structured Text name of its type
    name: String,
    set: String,
    /// structure id and set number, as in the heads of files
    shown: [String; 2],
    /// each with its value as text
    members: Vec<(String, String)>,
}

fn listed<'a>(
    designed: &Designed,
    axis: &'a BlockIdentity,
    block: &Block,
    language: &Language,
    [prefix, name]: [String; 2],
    extension: &str,
) -> Listed<'a> {
    let set = format!("{:08x}", designed.sets[1]);
    Listed {
        axis,
        file: if extension == "c" { format!("{name}.c") } else { format!("{prefix}_set_{set}.{extension}") },
        block: prefix,
        name,
        set,
        shown: designed.sets.map(blocks::shown),
        members: members(block, language).into_iter().map(|(name, value)| (name, (language.literal)(value))).collect(),
    }
}

/// The block that takes the sets; `None` if no block takes any.
fn block(designed: &Designed) -> Result<Option<Block>, Defect> {
    let kind = blocks::named(IPC).filter(|_| designed.axis.ipc.takes_sets());
    kind.map(|kind| kind.block(designed)).transpose()
}

/// The members of the set that the block was generated with, in its order, with their names in a language.
fn members(block: &Block, language: &Language) -> Vec<(String, Literal)> {
    let program = &block.for_axis.program;
    let [names, _] = signals(program, language);
    let all = program.inputs.iter().zip(names).filter(|(input, _)| program.in_set(input).is_some());
    // A caller writes the name after that of the set.
    all.map(|(input, name)| (name.rsplit('.').next().unwrap_or_default().to_owned(), input.start)).collect()
}

/// What the names of the block begin with in every language but C.
fn in_all(axis: &BlockIdentity, block: &Block) -> String {
    block_name(&axis.name, block.program.block)
}

/// What the names of the block begin with in C, which its header is called by, and the name of the set. With short
/// names it has at most 31 characters.
fn names_in_c(axis: &BlockIdentity, block: &Block, set: u32) -> [String; 2] {
    let header = c_prefix(axis, block.program.block);
    let between = if axis.short_names { "set" } else { "set_" };
    let name = format!("{header}_{between}{set:08x}");
    [header, name]
}

/// A line of a CSV file. The digits read back to the same bits.
fn line((name, value): &(String, Literal)) -> String {
    match value {
        Literal::F64(value) => format!("{name},{value:?}\n"),
        Literal::F32(value) => format!("{name},{value:?}\n"),
        Literal::U32(value) => format!("{name},{value}\n"),
        Literal::I32(value) => format!("{name},{value}\n"),
        Literal::Bool(value) => format!("{name},{}\n", u8::from(*value)),
        Literal::Usize(_) | Literal::Variant(_) => {
            unreachable!("params_of: the typing pass leaves what exists at run time")
        }
    }
}

/// The bytes in a struct on a little-endian machine.
fn little_endian(value: Literal) -> Vec<u8> {
    match value {
        Literal::F64(value) => value.to_le_bytes().to_vec(),
        Literal::F32(value) => value.to_le_bytes().to_vec(),
        Literal::U32(value) => value.to_le_bytes().to_vec(),
        Literal::I32(value) => value.to_le_bytes().to_vec(),
        Literal::Bool(value) => vec![u8::from(value)],
        Literal::Usize(_) | Literal::Variant(_) => {
            unreachable!("params_of: the typing pass leaves what exists at run time")
        }
    }
}
