//! The differences between the dialects of Structured Text in their files; differences in statements are in `print/st`.

use compiler::print::{Language, st};

/// The notation of a dialect around the statements.
pub(super) struct Dialect {
    pub(super) language: &'static Language,
    /// the beginning of the names of function blocks
    pub(super) prefix: &'static str,
    /// quotes around the name of a function block that is the type of a variable
    pub(super) quote: &'static str,
    /// the mark of a variable in a statement
    pub(super) mark: &'static str,
    /// the caller's arguments for the inputs `mode`, `task_cycle_ns` and `cycle_counter`
    pub(super) arguments: [&'static str; 3],
}

pub(super) static ST: Dialect = Dialect {
    language: &st::PLAIN,
    prefix: "",
    quote: "",
    mark: "",
    arguments: ["mode", "task_cycle_ns", "cycle_counter"],
};

pub(super) static CODESYS: Dialect = Dialect {
    language: &st::CODESYS,
    prefix: "FB_",
    arguments: ["E_axgen_mode.MODE_DRYRUN", "task_cycle_ns", "cycle_counter"],
    ..ST
};

/// Only the call differs.
pub(super) static TWINCAT: Dialect = Dialect {
    // The block reads the counter of its task if 0 is passed.
    arguments: ["E_axgen_mode.MODE_DRYRUN", "100 * _TaskInfo[GETCURTASKINDEXEX()].CycleTime", "0"],
    ..CODESYS
};

pub(super) static SIEMENS: Dialect = Dialect {
    language: &st::SCL,
    prefix: "FB_",
    quote: "\"",
    mark: "#",
    arguments: ["\"axgen_mode\".MODE_DRYRUN", "#task_cycle_ns", "#cycle_counter"],
};
