//! Feedforward: weights, time constants, delays, scalings.

use crate::axis::{Axis, Feedforward, Quantities, Torque, Width};
use crate::design::{delay::delay, scale};
use reference::{call_rate, feedforward};

/// Coefficients of feedforward for one axis; all zero for an axis without it.
///
/// - weight = vs_v_faktor / vs_v_nenner (P-AXIS-00228/00229).
/// - t_a = vs_a_faktor / vs_a_nenner * 1e-6 s (P-AXIS-00225/00226).
/// - t_j = jerk_fact_num / jerk_fact_denom * t_a^2 (P-AXIS-00337/00338).
/// - torque_acceleration: [`scale::torque`] times the plain weight vs_a_faktor / vs_a_nenner.
/// - torque_jerk: [`scale::torque`] times the jerk factor, read in seconds; inferred from units.
pub(crate) fn coefficients(axis: &Axis) -> feedforward::Coeffs<f64> {
    let Some(of) = &axis.control.feedforward else { return feedforward::Coeffs::default() };
    let weight = of.weight.value();
    let t_a = time_constant(of);
    let torque = of.torque_scale.as_ref().map_or(0.0, scale::torque);
    let velocity = of.velocity.as_ref();
    feedforward::Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        default_active: of.default_active,
        global_disable: of.global_disable,
        conventional: quantities(of.conventional),
        additive: quantities(of.additive),
        torque: quantities(of.torque),
        weight,
        weight_per_percent: weight / 100.0,
        t_a,
        t_j: of.jerk.value() * t_a * t_a,
        velocity_delay: delay(of.velocity_delay, axis.cycle_time_ns),
        acceleration_delay: delay(of.acceleration_delay, axis.cycle_time_ns),
        jerk_delay: delay(of.jerk_delay, axis.cycle_time_ns),
        velocity_scale: velocity.map_or(0.0, |velocity| scale::velocity(velocity, axis.cycle_time_ns)),
        velocity_range: scale::range(velocity.map_or(Width::Int32, |velocity| velocity.width), axis.real),
        torque_acceleration: torque * of.acceleration.value(),
        torque_jerk: torque * of.jerk.value(),
        torque_range: scale::range(of.torque_scale.as_ref().map_or(Width::Int32, |torque| torque.width), axis.real),
        call_rate: call_rate::Coeffs { active: axis.counts_calls },
    }
}

/// Time constant of the acceleration Ta [s].
pub(crate) fn time_constant(of: &Feedforward) -> f64 {
    f64::from(of.acceleration.num) / (f64::from(of.acceleration.denom) * 1e6)
}

/// The torque or force for 1 m/s^2 or 1000 deg/s^2, before it is weighted, in units of the nominal one.
pub(crate) fn nominal_torques(torque: &Torque) -> f64 {
    scale::torque(torque) * 1e6 / torque.scale.value()
}

fn quantities(of: Quantities) -> feedforward::Quantities {
    feedforward::Quantities { velocity: of.velocity, acceleration: of.acceleration, jerk: of.jerk }
}
