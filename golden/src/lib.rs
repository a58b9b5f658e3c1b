//! Stimuli, vectors, and the engines that must agree on every bit.
//!
//! Next to this crate: `cases` (golden cases), `machine` (simulated machines), `nc` (NC programs), `st` (the engine for ST).
//!
//! ```text
//! stimulus   what the inputs do, sample by sample; waveform: the forms that it is made of, from integers and libm
//! samples    the values of all signals of a run, packed; csv: the same as text; value: a cell of it
//! table      the forms that recorders give it; signals: which column is which; series, instants, written: the values of the
//!            columns, when they were taken, how many digits they have; mistake: what is wrong with them
//! engine     the ways to run a block: reference, program, c, rust, and the emitted Structured Text
//! recording  what a controller recorded, and how far it agrees
//! evidence   what a recording can prove; explain: which of the commonest mistakes explains that it differs
//! compare    how many bits of two runs differ, and where first
//! exercise   what a user's own blocks are run with, and what it reached
//! subject    the reference of a block in a loop, signal by signal, and its record
//! drive      the drive of an axis as a machine, and whether its loop oscillates
//! scenario   the inputs that an NC program makes, in a loop with a machine, and its picture
//! analysis   the picture of an analysis; svg: how pictures are drawn
//! simulate   improved position control in the loop of an axis, with and without it: figures, pictures, CSV
//! measure    what a recording shows of an axis: sampling, vibrations, its response
//! tune       stages that a recording asks for, and what they would leave of its vibrations
//! source     the inputs of a case: a stimulus, or those that a scenario has once made
//! case       a folder with an axis set, a stimulus or a scenario, and the answers that were recorded
//! shows      what a case has in it: so that none can silently cease to show what it is there for
//! ```
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
