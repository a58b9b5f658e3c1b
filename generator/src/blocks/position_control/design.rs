//! Position control: gain, lag, scalings.

use crate::axis::{Axis, Location, PositionControl, Width};
use crate::design::{delay, scale};
use reference::{axis, call_rate, position_control};

/// Coefficients of position control for one axis; all zero for an axis without it.
///
/// - kv = getriebe.kv * 0.01 1/s (P-AXIS-00099); lag = 1 / kv.
/// - manipulated_scale = [`scale::manipulated`].
/// - velocity_scale = [`scale::velocity`].
/// - xerr_scale = 10 R, in increments per um or 0.001 deg, R as in [`scale::resolution`].
pub(crate) fn coefficients(axis: &Axis) -> position_control::Coeffs<f64> {
    let Some(of) = &axis.control.position_control else { return position_control::Coeffs::default() };
    let quantities = axis.control.feedforward.as_ref();
    let velocity = of.velocity.as_ref();
    position_control::Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        location: of.location,
        feedforward: quantities.is_some_and(|feedforward| feedforward.conventional.any()),
        additive: quantities.is_some_and(|feedforward| feedforward.additive.any()),
        adds: adds(axis, of),
        torque: quantities.is_some_and(|feedforward| feedforward.torque.any()),
        kv: kv(of),
        lag: if of.kv > 0 { 100.0 / f64::from(of.kv) } else { 0.0 },
        manipulated_scale: scale::manipulated(of.multi_gain),
        manipulated_range: scale::range(of.command, axis.real),
        shift: delay::whole(of.shift_time),
        xerr_scale: of.resolution.as_ref().map_or(0.0, |resolution| 10.0 * scale::resolution(resolution)),
        xerr_range: scale::range(Width::Int32, axis.real),
        velocity_scale: velocity.map_or(0.0, |velocity| scale::velocity(velocity, axis.cycle_time_ns)),
        velocity_range: scale::range(velocity.map_or(Width::Int32, |velocity| velocity.width), axis.real),
        call_rate: call_rate::Coeffs { active: axis.counts_calls },
    }
}

/// Gain of the position controller Kv [1/s].
pub(crate) fn kv(of: &PositionControl) -> f64 {
    f64::from(of.kv) / 100.0
}

/// Whether an additive velocity of improved position control is output: the axis's own, or the gantry master's.
fn adds(axis: &Axis, of: &PositionControl) -> bool {
    addition(axis) != axis::Addition::None && (of.location == Location::Cnc || of.velocity.is_some())
}

/// The source of the additive velocity.
pub(crate) fn addition(axis: &Axis) -> axis::Addition {
    match (axis.control.master, axis.control.master_limit) {
        (Some(_), Some(_)) => axis::Addition::Master,
        (None, _) if axis.ipc.takes_sets() => axis::Addition::Sets,
        (None, _) if axis.ipc.is_active() => axis::Addition::Ipc,
        _ => axis::Addition::None,
    }
}
