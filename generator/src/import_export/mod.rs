//! An axis list to a TOML set (import) and back (export) without loss. The lines of a list are split in `config/lines.rs`.
//!
//! The set contains each value once, as TOML. The lines of the list stay in the set too, with `=` in place of the values:
//! they preserve order, blanks, comments and the parameters of other functions.

mod encoding;
mod export;
mod fill;
mod import;
mod keys_of_stage;
mod slot;
mod spelling;
mod stages;
mod stages_in_list;
mod stages_in_set;
mod tables;

pub use export::export;
pub use import::import;
pub use stages::with_stages;
