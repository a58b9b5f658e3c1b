//! Stimuli, vectors, and the engines that must agree on every bit.
//!
//! ```text
//! stimulus   what the inputs do, sample by sample; waveform: the forms that it is made of, from integers and libm
//! samples    the values of all signals of a run, packed; csv: the same as text; table: the forms that recorders give it
//! engine     the ways to run a block: reference, program, c, rust, and the emitted Structured Text
//! recording  what a controller recorded, and how far it agrees
//! compare    how many bits of two runs differ, and where first
//! exercise   what a user's own blocks are run with, and what it reached
//! subject    the reference of a block in a loop, signal by signal, and its record
//! scenario   the inputs that an NC program makes, in a loop with a machine; svg: its picture, as text
//! simulate   improved position control in the loop of an axis, with and without it: figures, pictures, CSV
//! source     the inputs of a case: a stimulus, or those that a scenario has once made
//! case       a folder with an axis set, a stimulus or a scenario, and the answers that were recorded
//! shows      what a case has in it: so that none can silently cease to show what it is there for
//! ```
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]

pub mod case;
pub mod compare;
pub mod csv;
pub mod engine;
pub mod exercise;
pub mod recording;
pub mod samples;
pub mod scenario;
pub mod shows;
pub mod simulate;
pub mod source;
pub mod stimulus;
pub mod subject;
pub mod svg;
pub mod table;
pub mod waveform;
