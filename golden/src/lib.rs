//! Stimuli, vectors, and the engines that must agree on every bit.
//!
//! Next to this crate: `cases` (golden cases), `machine` (simulated machines), `nc` (NC programs), `st` (the engine for ST).
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]

pub mod analysis;
pub mod case;
pub mod compare;
pub mod csv;
pub mod drive;
pub mod engine;
pub mod evidence;
pub mod exercise;
pub mod explain;
mod instants;
pub mod measure;
pub mod mistake;
pub mod recording;
pub mod samples;
pub mod scenario;
mod series;
pub mod shows;
pub mod signals;
pub mod simulate;
pub mod source;
pub mod stimulus;
pub mod subject;
pub mod svg;
pub mod table;
pub mod tune;
pub mod value;
pub mod waveform;
pub mod written;
