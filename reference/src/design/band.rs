//! Where a filter lies on the warped frequency axis. No pole, no coefficient.

use super::tangent::tangent;
use portable::{Real, from_u32, portable};

/// Centre and bandwidth on the warped frequency axis t = tan(pi f Ts), where s = j t and
/// s = (1 - z^-1) / (1 + z^-1).
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Band<R> {
    /// centre: Omega0 = tan(pi f0 Ts)
    pub omega0: R,
    /// distance of the edges: B = (1 + Omega0^2) tan(pi f0 Ts / Q)
    pub bandwidth: R,
}

/// The band about `f0` [Hz] whose edges are `f0 / q_factor` apart, at the cycle time Ts [s].
///
/// Omega0 = tan(pi f0 Ts), B = (1 + Omega0^2) tan(pi f0 Ts / Q). The edges t1 and t2 obey t1 t2 = Omega0^2 and
/// t2 - t1 = B, so that tan(pi (f2 - f1) Ts) = (t2 - t1) / (1 + t1 t2) = tan(pi f0 Ts / Q): their distance in Hz is
/// f0 / Q without any approximation (P-AXIS-00751, P-AXIS-00752).
#[portable]
pub fn band<R: Real>(band: &mut Band<R>, f0: R, q_factor: R, cycle_time: R) {
    let omega0 = warped(f0, cycle_time);
    band.omega0 = omega0;
    band.bandwidth = (R::ONE + omega0 * omega0) * warped(f0 / q_factor, cycle_time);
}

/// t = tan(pi f Ts) of a frequency [Hz] at the cycle time [s], f Ts <= 0.45.
#[portable]
pub fn warped<R: Real>(frequency: R, cycle_time: R) -> R {
    tangent(R::lit(core::f64::consts::PI) * frequency * cycle_time)
}

/// The cycle time [s] of a cycle in whole nanoseconds.
#[portable]
pub fn cycle_time<R: Real>(ns: u32) -> R {
    from_u32::<R>(ns) * R::lit(1.0e-9)
}
