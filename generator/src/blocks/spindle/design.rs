//! The changeover: velocities, times and scalings as coefficients.

use super::limits::window;
use crate::axis::{Axis, Changeover, Spindle};
use crate::design::rounding::{in_precision, sample_limit};
use crate::design::scale;
use portable::Extreme;
use reference::call_rate;
use reference::spindle::Coeffs;

/// Half a turn [0.001 deg].
const HALF_TURN: f64 = 180_000.0;

/// Leaves a margin for roundings, in either precision.
const ROUNDING: f64 = 1.0 - 1.0 / 1_048_576.0;

/// Number of extra cycles of the test of a spindle whose drive is switched on.
const START: u32 = 2;

/// Coefficients of the changeover of one axis; all zero for an axis without it.
///
/// ```text
/// lead_time = (Nd + 1) T + (1 - w) / Kv        position control in the drive, w its feedforward; reduced by the weight of an
///                                              additive velocity / Kv while feedforward is active
/// lead_time = (Nd + 1) T                       velocity control alone: no position controller lags
/// lead_time = T + 1 / Kv                       position control in the CNC: its loop compares with the delayed
///                                              x_actual, so the delay is part of the lag; reduced by w / Kv while
///                                              feedforward is active
/// ```
pub(crate) fn coefficients(axis: &Axis) -> Coeffs<f64> {
    let Some(of) = &axis.control.spindle else { return Coeffs::default() };
    let cycle_time = axis.cycle_time();
    let off = f64::from(of.v_position_control_on);
    let window = window(of.v_position_control_on, of.window);
    let lag = if of.only_velocity() { 0.0 } else { (1.0 - weight(of)) / kv(of) };
    let mode_cycles = cycles(of.mode_timeout_ns, axis);
    Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        cycle_time,
        v_velocity_control_on: f64::from(of.v_velocity_control_on),
        v_position_control_on: off,
        v_position_control_on_negative: 0.0 - off, // not `-off`: 0 stays +0
        window,
        v_taken_up: off + window,
        v_step: of.deceleration * cycle_time,
        v_largest: v_largest(axis),
        v_usual_position: usual_position(of, axis),
        v_usual_velocity: usual_velocity(of, axis),
        lead_time: f64::from(of.delay_cycles + 1) * cycle_time + lag,
        takeover_window: of.takeover_window,
        takeover_way: of.deceleration * cycle_time * cycle_time / 2.0,
        mode_cycles,
        start_cycles: mode_cycles.saturating_add(START),
        brake_cycles: cycles(of.brake_timeout_ns, axis),
        has_feedforward: of.feedforward.is_some(),
        default_active: of.default_active,
        lead_time_per_percent: of.feedforward.map_or(0.0, |weight| weight.value() / 100.0 / kv(of)),
        call_rate: call_rate::Coeffs { active: axis.counts_calls },
        ..in_drive(of, axis)
    }
}

/// The coefficients of a changeover in the drive, its modes and its velocity command; all zero in the CNC.
fn in_drive(of: &Spindle, axis: &Axis) -> Coeffs<f64> {
    match &of.drive {
        Changeover::Cnc => Coeffs::default(),
        Changeover::Drive { position_mode, velocity_mode, velocity, .. } => Coeffs {
            in_drive: true,
            only_velocity: of.only_velocity(),
            position_mode: *position_mode,
            velocity_mode: *velocity_mode,
            velocity_scale: scale::velocity(velocity, axis.cycle_time_ns),
            velocity_range: scale::range(velocity.width, axis.real),
            ..Coeffs::default()
        },
    }
}

/// Gain of the position controller Kv [1/s].
pub(crate) fn kv(of: &Spindle) -> f64 {
    f64::from(of.kv) / 100.0
}

/// Weight w of the drive's feedforward; 0 with position control in the CNC.
pub(crate) fn weight(of: &Spindle) -> f64 {
    match of.drive {
        Changeover::Cnc => 0.0,
        Changeover::Drive { feed_forward_v_weighting, .. } => f64::from(feed_forward_v_weighting) / 1000.0,
    }
}

/// The largest velocity at which a drive can detect the direction [0.001 deg/s].
pub(crate) fn v_largest(axis: &Axis) -> f64 {
    scale::below(half_turn(axis), axis.real).smaller(sample_limit(axis.real))
}

/// The largest velocity of a usual cycle of VELOCITY [0.001 deg/s]: the velocity command is within its range, also after rounding.
fn usual_velocity(of: &Spindle, axis: &Axis) -> f64 {
    let (scale, width) = match (&of.drive, &axis.control.position_control) {
        (Changeover::Drive { velocity, .. }, _) => (scale::velocity(velocity, axis.cycle_time_ns), velocity.width),
        (Changeover::Cnc, Some(control)) => (scale::manipulated(control.multi_gain), control.command),
        (Changeover::Cnc, None) => return sample_limit(axis.real),
    };
    let largest = scale::range(width, axis.real).upper_limit / scale;
    (largest * ROUNDING).smaller(sample_limit(axis.real))
}

/// The largest velocity of a usual cycle of POSITION [0.001 deg/s]: no transition is due, and a drive can detect the direction.
fn usual_position(of: &Spindle, axis: &Axis) -> f64 {
    let on = in_precision(f64::from(of.v_velocity_control_on), axis.real);
    let below_on = if of.only_velocity() { 0.0 } else { scale::below(on, axis.real) };
    below_on.smaller(v_largest(axis)).smaller(usual_velocity(of, axis))
}

/// The velocity from which a drive cannot detect the direction [0.001 deg/s].
pub(crate) fn half_turn(axis: &Axis) -> f64 {
    HALF_TURN * 1e9 / f64::from(axis.cycle_time_ns)
}

/// A time in cycles, rounded up.
fn cycles(ns: u64, axis: &Axis) -> u32 {
    u32::try_from(ns.div_ceil(u64::from(axis.cycle_time_ns))).unwrap_or(u32::MAX)
}
