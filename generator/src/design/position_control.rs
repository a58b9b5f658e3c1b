//! Position control: gain, lag, scalings. And the whole axis, which is its parts side by side.

use super::{feedforward, ipc, scale};
use crate::axis::{Axis, Place, PositionControl, Width};
use portable::Real;
use reference::{axis, delay, position_control};

/// Coefficients of position control for one axis; of an axis without it all zero.
///
/// - kv = getriebe.kv * 0.01 1/s (P-AXIS-00099); lag = 1 / kv.
/// - manipulated_scale = [`scale::manipulated`].
/// - velocity_scale = [`scale::velocity`].
/// - xerr_scale = 10 R, in increments per um or 0.001 deg, R as in [`scale::resolution`].
#[must_use]
pub fn coefficients<R: Real>(axis: &Axis) -> position_control::Coeffs<R> {
    let Some(of) = &axis.control.position_control else { return position_control::Coeffs::default() };
    let quantities = axis.control.feedforward.as_ref();
    let velocity = of.velocity.as_ref();
    position_control::Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        place: match of.place {
            Place::Cnc => position_control::Place::Cnc,
            Place::Drive => position_control::Place::Drive,
            Place::Profidrive => position_control::Place::Profidrive,
        },
        feedforward: quantities.is_some_and(|feedforward| feedforward.conventional.any()),
        additive: quantities.is_some_and(|feedforward| feedforward.additive.any()),
        adds: adds(axis, of),
        torque: quantities.is_some_and(|feedforward| feedforward.torque.any()),
        kv: R::lit(kv(of)),
        lag: R::lit(if of.kv > 0 { 100.0 / f64::from(of.kv) } else { 0.0 }),
        manipulated_scale: R::lit(scale::manipulated(of.multi_gain)),
        manipulated_range: scale::range(of.command),
        shift: delay::Coeffs {
            whole: usize::try_from(of.shift_time).expect("design: a few cycles"),
            fractional: false,
            now: R::ONE,
            before: R::ZERO,
        },
        xerr_scale: R::lit(of.resolution.as_ref().map_or(0.0, |resolution| 10.0 * scale::resolution(resolution))),
        xerr_range: scale::range(Width::Int32),
        velocity_scale: R::lit(velocity.map_or(0.0, |velocity| scale::velocity(velocity, axis.cycle_time_ns))),
        velocity_range: scale::range(velocity.map_or(Width::Int32, |velocity| velocity.width)),
    }
}

/// Gain of the position controller Kv [1/s].
#[must_use]
pub fn kv(of: &PositionControl) -> f64 {
    f64::from(of.kv) / 100.0
}

/// Whether an additive velocity of improved position control goes out: its own, or the gantry master's.
fn adds(axis: &Axis, of: &PositionControl) -> bool {
    addition(axis) != axis::Addition::None && (of.place == Place::Cnc || of.velocity.is_some())
}

/// Where the additive velocity comes from.
#[must_use]
pub fn addition(axis: &Axis) -> axis::Addition {
    let control = &axis.control;
    if control.master.is_some() {
        control.master_limit.map_or(axis::Addition::None, |_| axis::Addition::Master)
    } else if axis.ipc.stage.iter().any(Option::is_some) {
        axis::Addition::Ipc
    } else {
        axis::Addition::None
    }
}

/// Coefficients of the block `axis`.
#[must_use]
pub fn of_axis<R: Real>(axis: &Axis) -> axis::Coeffs<R> {
    let limit = axis.control.master_limit.unwrap_or(0.0);
    axis::Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        addition: addition(axis),
        has_feedforward: axis.control.feedforward.is_some(),
        master_limit: R::lit(limit),
        master_lower_limit: R::lit(0.0 - limit), // not `-limit`: 0 stays +0
        feedforward: feedforward::coefficients(axis),
        ipc: ipc::coefficients(axis),
        position_control: coefficients(axis),
    }
}
