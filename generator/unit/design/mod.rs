//! The design against closed forms, an independent implementation and the reference's own `step`. No golden files.

mod allpass;
mod bandpass;
mod feedforward;
mod golden;
mod oscillation;
mod refused;
mod response;
mod rounding;
mod scipy;
mod tree;
