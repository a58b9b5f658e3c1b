//! Where a filter lies on the warped frequency axis: centre, bandwidth, edges. No pole, no coefficient.

use core::f64::consts::PI;

/// Centre and bandwidth on the warped frequency axis t = tan(pi f Ts), where s = j t and
/// s = (1 - z^-1) / (1 + z^-1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Band {
    /// centre: Omega0 = tan(pi f0 Ts)
    pub omega0: f64,
    /// distance of the edges: B = (1 + Omega0^2) tan(pi f0 Ts / Q)
    pub bandwidth: f64,
}

/// The band about `f0` [Hz] whose edges are `f0 / q_factor` apart, at the cycle time Ts [s].
///
/// Omega0 = tan(pi f0 Ts), B = (1 + Omega0^2) tan(pi f0 Ts / Q). The edges t1 and t2 obey t1 t2 = Omega0^2 and
/// t2 - t1 = B, so that tan(pi (f2 - f1) Ts) = (t2 - t1) / (1 + t1 t2) = tan(pi f0 Ts / Q): their distance in Hz is
/// f0 / Q without any approximation (P-AXIS-00751, P-AXIS-00752).
pub(crate) fn band(f0: f64, q_factor: f64, cycle_time: f64) -> Band {
    let omega0 = warped(f0, cycle_time);
    let bandwidth = (1.0 + omega0 * omega0) * warped(f0 / q_factor, cycle_time);
    Band { omega0, bandwidth }
}

/// Lower and upper edge, where a band-pass has 1/sqrt(2) of its gain, on the warped axis.
///
/// t = -+B/2 + sqrt(B^2/4 + Omega0^2); the lower one as Omega0^2 / t2, because the difference cancels in a wide band.
pub(crate) fn edges(band: &Band) -> [f64; 2] {
    let half = band.bandwidth / 2.0;
    let upper = half + libm::sqrt(half * half + band.omega0 * band.omega0);
    [band.omega0 / upper * band.omega0, upper]
}

/// t = tan(pi f Ts) of a frequency [Hz] at the cycle time [s].
pub(crate) fn warped(frequency: f64, cycle_time: f64) -> f64 {
    libm::tan(PI * frequency * cycle_time)
}

/// The frequency [Hz] of a point t = tan(pi f Ts) of the warped axis at the cycle time [s].
pub(crate) fn frequency(t: f64, cycle_time: f64) -> f64 {
    libm::atan(t) / (PI * cycle_time)
}
