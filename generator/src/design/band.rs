//! Points of the warped frequency axis: edges of a band, frequencies. Centre and bandwidth are in `reference::design`.

use core::f64::consts::PI;
use reference::design::band;

/// Centre and bandwidth on the warped frequency axis t = tan(pi f Ts).
pub type Band = band::Band<f64>;

/// The band about `f0` [Hz] whose edges are `f0 / q_factor` apart, at the cycle time [s].
pub fn band(f0: f64, q_factor: f64, cycle_time: f64) -> Band {
    let mut of = Band::default();
    band::band(&mut of, f0, q_factor, cycle_time);
    of
}

/// Lower and upper edge, where a band-pass has 1/sqrt(2) of its gain, on the warped axis.
///
/// t = -+B/2 + sqrt(B^2/4 + Omega0^2); the lower one as Omega0^2 / t2, because the difference cancels in a wide band.
pub fn edges(band: &Band) -> [f64; 2] {
    let half = band.bandwidth / 2.0;
    let upper = half + libm::sqrt(half * half + band.omega0 * band.omega0);
    [band.omega0 / upper * band.omega0, upper]
}

/// t = tan(pi f Ts) of any frequency [Hz] at the cycle time [s], for a response. A design has the same bits from its own
/// tangent, which ends at f Ts = 0.45.
pub fn warped(frequency: f64, cycle_time: f64) -> f64 {
    libm::tan(PI * frequency * cycle_time)
}

/// The frequency [Hz] of a point t = tan(pi f Ts) of the warped axis at the cycle time [s].
pub fn frequency(t: f64, cycle_time: f64) -> f64 {
    libm::atan(t) / (PI * cycle_time)
}
