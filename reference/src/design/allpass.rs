//! An all-pass of second order: its section. No coefficient.

use super::band::Band;
use super::sections::Shape;
use portable::{Real, portable};

/// g = Omega0, k = B / Omega0.
///
/// H = (s^2 - B s + Omega0^2) / (s^2 + B s + Omega0^2) = 1 - 2 H_BP, H_BP the band-pass of order 1 in the same band.
/// |H| = 1 everywhere; the phase falls from 0 at DC over -90 degrees at the lower edge, -180 degrees at the centre
/// (P-AXIS-00751) and -270 degrees at the upper edge to -360 degrees at the Nyquist frequency.
#[portable]
pub fn section<R: Real>(shape: &mut Shape<R>, band: &Band<R>) {
    shape.g = band.omega0;
    shape.k = band.bandwidth / band.omega0;
    shape.c = R::ONE;
}
