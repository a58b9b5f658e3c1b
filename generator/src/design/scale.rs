//! Scalings from path units to the units of the drive, and the ranges of process data. No filter.

use crate::axis::{Motor, Ratio, Resolution, TimeBase, Torque, Velocity, Width};
use portable::{Real, RealKind};
use reference::process_data;

/// Additive velocity: increments for 1 um/s or 0.001 deg/s,
///
/// ```text
/// v_reso_num / v_reso_denom * tb,    tb = 60 per minute, 1 per second, Ts per cycle
/// ```
///
/// (P-AXIS-00205 to 00207). The numerator is exact up to 2^53, so that there is one rounding.
pub fn velocity(velocity: &Velocity, cycle_time_ns: u32) -> f64 {
    let (num, denom) = (f64::from(velocity.reso.num), f64::from(velocity.reso.denom));
    match velocity.time_base {
        TimeBase::Minute => num * 60.0 / denom,
        TimeBase::Second => num / denom,
        TimeBase::Cycle => num * f64::from(cycle_time_ns) / (denom * 1e9),
    }
}

/// Manipulated variable: increments for 1 um/s or 0.001 deg/s, `60e-6 multi_gain_z / multi_gain_n` (P-AXIS-00129/00128).
pub fn manipulated(multi_gain: Ratio) -> f64 {
    f64::from(multi_gain.num) * 60.0 / (f64::from(multi_gain.denom) * 1e6)
}

/// Path resolution R in increments per 0.1 um or 0.0001 deg,
///
/// ```text
/// R = incr_per_rev * wegaufz / wegaufn * feed_const_denom / feed_const_num    if a feed constant is given
/// R = wegaufz / wegaufn                                                       else
/// ```
///
/// (P-AXIS-00092, 00233, 00234, 00362, 00363). A feed constant is given where one of its parameters is not 1.
pub fn resolution(resolution: &Resolution) -> f64 {
    let (wegauf, feed) = (resolution.wegauf, resolution.feed_const);
    if !resolution.has_feed_const() {
        return wegauf.value();
    }
    let num = f64::from(resolution.incr_per_rev) * f64::from(wegauf.num) * f64::from(feed.denom);
    num / (f64::from(wegauf.denom) * f64::from(feed.num))
}

/// Angular acceleration of the motor for an acceleration of 1 um/s^2 or 0.001 deg/s^2 [rad/s^2]:
/// `alpha = 10 a R / incr_per_rev 2 pi`, with a in um/s^2.
pub fn angular_acceleration(of: &Resolution) -> f64 {
    10.0 * resolution(of) / f64::from(of.incr_per_rev) * 2.0 * std::f64::consts::PI
}

/// Additive torque: increments for 1 um/s^2 or 0.001 deg/s^2,
///
/// ```text
/// M = load * alpha, of a linear motor F = load * a
/// increments = M / acc_reference_value * torque_scale_num / torque_scale_denom
/// ```
///
/// (P-AXIS-00391, 00392, 00325, 00326), before it is weighted.
pub fn torque(torque: &Torque) -> f64 {
    let per_acceleration = match torque.motor {
        Motor::Rotary => torque.load * angular_acceleration(&torque.resolution),
        Motor::Linear => torque.load * 1e-6,
    };
    per_acceleration / torque.reference * torque.scale.value()
}

/// The range of a process datum for a block of that real type.
///
/// The limits are the outermost numbers of the real type that are rounded to its boundaries, so that no number within them is
/// rounded beyond. In single precision they differ from the boundaries: 2147483647 itself would become 2^31.
pub fn range(width: Width, real: RealKind) -> process_data::Coeffs<f64> {
    let [lowest, highest] = width.range();
    let upper_limit = below(f64::from(highest) + 0.5, real);
    let lower_limit = 0.0 - below(0.5 - f64::from(lowest), real);
    process_data::Coeffs { lowest, highest, lower_limit, upper_limit }
}

/// The largest number of the real type below a boundary.
pub fn below(boundary: f64, real: RealKind) -> f64 {
    match (real, f32::lit(boundary)) {
        (RealKind::F64, _) => boundary.next_down(),
        (RealKind::F32, nearest) if f64::from(nearest) < boundary => nearest.into(),
        // A number that was rounded up is replaced by the next lower one.
        (RealKind::F32, nearest) => nearest.next_down().into(),
    }
}
