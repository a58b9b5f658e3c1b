//! The simulated oscillation of the INDIRECT and SET_POINT modes: its section. No coefficient.

use super::sections::Shape;
use portable::{Real, portable};

/// g = Omega0 of the stage's first band-pass, k = 2 D with the damping ratio D (P-AXIS-00850).
///
/// The velocity of a load after a visco-elastic coupling: H(s) = (k g s + g^2) / (s^2 + k g s + g^2).
/// H(f0) = 1 + 1 / (2 j D), gain 1 at DC. Lower damping, larger simulated vibration. The vendor documents state this
/// behaviour and no equation: that the coupling is visco-elastic is an inference from it.
#[portable]
pub fn section<R: Real>(shape: &mut Shape<R>, omega0: R, damping: R) {
    shape.g = omega0;
    shape.k = R::lit(2.0) * damping;
    shape.c = R::ONE;
}
