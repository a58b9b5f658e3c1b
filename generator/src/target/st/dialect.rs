//! What differs between the dialects of Structured Text in their files; what differs in statements, `print/st` says.

use compiler::print::Language;
use compiler::print::st::{PLAIN, SCL};

/// What the files of a dialect do differently around the statements.
pub(super) struct Dialect {
    pub(super) language: &'static Language,
    /// what the names of function blocks begin with
    pub(super) prefix: &'static str,
    /// around the name of a function block that is the type of a variable
    pub(super) quote: &'static str,
    /// before a variable in a statement
    pub(super) mark: &'static str,
    /// what a caller gives to the inputs `mode`, `task_cycle_ns` and `cycle_counter`
    pub(super) arguments: [&'static str; 3],
}

pub(super) static ST: Dialect = Dialect {
    language: &PLAIN,
    prefix: "",
    quote: "",
    mark: "",
    arguments: ["mode", "task_cycle_ns", "cycle_counter"],
};

pub(super) static SIEMENS: Dialect = Dialect {
    language: &SCL,
    prefix: "FB_",
    quote: "\"",
    mark: "#",
    arguments: ["\"axgen_mode\".MODE_DRYRUN", "#task_cycle_ns", "#cycle_counter"],
};
