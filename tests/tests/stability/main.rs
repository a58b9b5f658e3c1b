//! The loop that improved position control closes, judged by what shares no line with the crate `stability`: eigenvalues of the whole loop,
//! a fine grid of frequencies, the emitted C in the loop.

mod eigenvalues;
mod emitted;
mod examples;
mod random;
