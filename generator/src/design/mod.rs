//! From physical, valid parameters to the reference's coefficients; the only place with trigonometry. No reading, no
//! checking of ranges, no printing.
//!
//! ```text
//! band       f0, Q, Ts -> warped centre and bandwidth
//! prototype  prototype, order -> poles of the low-pass
//! bandpass   poles, band -> sections, in the order of their execution -> coefficients
//! allpass    band -> coefficients
//! oscillation  warped centre, damping ratio -> coefficients
//! filter, stage, ipc  the parameter tree -> the tree of coefficients
//! scale      what the drive gets for a velocity, an acceleration
//! feedforward, position_control  the same for the blocks of their names, and for the whole axis
//! ```
//!
//! Beside it: `response` (what coefficients do), `unusable` (what rounding has spoilt), `notes` (what each one means).
//! Everything is computed in f64 with the `libm` crate, so that every host finds the same bits; a coefficient is rounded
//! once, where it is handed to the real type of the block.

pub mod allpass;
pub mod band;
pub mod bandpass;
pub mod control_notes;
pub mod denominator;
pub mod feedforward;
pub mod filter;
pub mod ipc;
pub mod notes;
pub mod oscillation;
pub mod position_control;
pub mod prototype;
pub mod response;
pub mod scale;
pub mod stage;
pub mod unusable;

pub use ipc::coefficients as ipc;
pub use notes::{digits, notes};
pub use scale::overflow;
pub use unusable::{Refusal, unusable};
