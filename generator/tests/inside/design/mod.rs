//! The design against closed forms, an independent implementation and the reference's own `step`. No golden files.

mod feedforward;
mod filters;
mod golden;
mod refused;
mod response;
mod rounding;
mod scipy;
mod tree;

use reference::design::oscillation as portable_oscillation;
use reference::design::sections::{Shape, oscillation_numbers};
use reference::oscillation::Coeffs;

/// The simulated oscillation with a warped centre and a damping ratio.
fn oscillation_of(omega0: f64, damping: f64) -> Coeffs<f64> {
    let (mut shape, mut coeffs) = (Shape::default(), Coeffs::default());
    portable_oscillation::section(&mut shape, omega0, damping);
    oscillation_numbers(&mut coeffs, &shape);
    coeffs
}
