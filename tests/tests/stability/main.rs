//! The loop that improved position control closes, judged by what shares no line with the crate `stability`: eigenvalues of the whole loop,
//! a fine grid of frequencies, the block itself in the loop.
#![expect(clippy::print_stdout, reason = "the figures of a report")]

mod calm;
mod eigenvalues;
mod emitted;
mod ideal_drive;
mod random;
mod set_point;
