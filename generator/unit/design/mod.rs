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

use crate::axis::Prototype;
use crate::blocks::ipc::filter::portable;
use crate::design::band::Band;
use reference::design::sections::{Shape, Shapes, oscillation_numbers};
use reference::design::{bandpass as portable_bandpass, oscillation as portable_oscillation};
use reference::oscillation::Coeffs;

/// The sections of a band-pass, in the order of their execution.
fn sections_of(prototype: Prototype, order: usize, band: &Band) -> Vec<Shape<f64>> {
    let mut shapes = Shapes::default();
    portable_bandpass::sections(&mut shapes, portable(prototype), order, band);
    shapes.section[..order].to_vec()
}

/// The simulated oscillation with a warped centre and a damping ratio.
fn oscillation_of(omega0: f64, damping: f64) -> Coeffs<f64> {
    let (mut shape, mut coeffs) = (Shape::default(), Coeffs::default());
    portable_oscillation::section(&mut shape, omega0, damping);
    oscillation_numbers(&mut coeffs, &shape);
    coeffs
}
