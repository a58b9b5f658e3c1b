//! The design: from frequencies, quality factors, damping ratios and weights to the numbers of a stage. No parameter, no
//! cycle of a block.
//!
//! ```text
//! tangent       tan x
//! square_root   sqrt x
//! band          f0, Q, Ts -> warped centre and bandwidth
//! poles         prototype, order -> poles of the low-pass prototype
//! bandpass      poles, band -> sections in the order of their execution
//! allpass       band -> section
//! oscillation   warped centre, damping -> section
//! sections      section -> coefficients
//! limit         weight, largest velocity -> gain, limit, largest sum that is not a fault
//! narrow        numbers -> numbers that single precision represents exactly
//! inputs        which input is outside its range
//! stage         all numbers of a stage
//! ```
//!
//! It uses `+`, `-`, `*`, `/` and comparisons, each rounded once to nearest: no function of a library, no fused operation, no
//! access to bits. So every language and every processor computes the same bits.
//!
//! Everything is computed in double precision, also for a block in single precision: 53.1 in single precision is another
//! frequency. Its numbers are rounded once, at the end ([`narrow`]). The functions are generic over the real type as all
//! portable functions; their constants fit double precision only.

pub mod allpass;
pub mod band;
pub mod bandpass;
pub mod inputs;
pub mod limit;
pub mod narrow;
pub mod oscillation;
pub mod poles;
pub mod sections;
pub mod square_root;
pub mod stage;
pub mod tangent;
