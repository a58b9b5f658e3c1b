//! The reference as what the model is compared with: parameters become coefficients here, and signals of the one those of the other.

use super::{Inputs, Outputs, Parameters};
use portable::{Extreme, copy};
use reference::process_data;
use reference::spindle::{self, Coeffs, State};

/// The reference before its first cycle.
pub fn start(p: &Parameters) -> impl FnMut(&Inputs) -> Outputs + use<> {
    let coeffs = coefficients(p);
    let (mut state, mut outputs) = (State::<f64>::default(), spindle::Outputs::default());
    spindle::init(&mut state);
    move |inputs| {
        spindle::step(&mut state, &coeffs, &inputs_of(inputs), &mut outputs);
        outputs_of(&outputs)
    }
}

/// The formulas of the page, once more: the generator's design has tests of its own.
#[must_use]
pub fn coefficients(p: &Parameters) -> Coeffs<f64> {
    let [lowest, highest] = p.velocity_range;
    let delay = if p.in_cnc { 0 } else { p.nd };
    let weight = if p.in_cnc { 0.0 } else { p.w };
    let lag = if p.only_velocity { 0.0 } else { (1.0 - weight) / p.kv };
    let half_turn = (180_000.0 / p.cycle).next_down();
    let v_usual = if p.in_cnc { 1e15 } else { (0.999_999 * f64::from(highest) / p.velocity_scale).smaller(1e15) };
    Coeffs {
        cycle_time_ns: p.cycle_ns,
        cycle_time: p.cycle,
        in_drive: !p.in_cnc,
        v_velocity_control_on: p.v_on,
        v_position_control_on: p.v_off,
        v_position_control_on_negative: -p.v_off,
        window: p.window,
        v_taken_up: p.v_off + p.window,
        only_position: p.only_position,
        only_velocity: p.only_velocity,
        closes_loop: p.closes_loop,
        v_step: p.deceleration * p.cycle,
        v_largest: half_turn,
        v_usual_position: p.v_on.next_down().smaller(half_turn).smaller(v_usual),
        v_usual_velocity: v_usual,
        lead_time: f64::from(delay + 1) * p.cycle + lag,
        has_feedforward: p.in_cnc && p.feedforward.is_some(),
        default_active: false,
        lead_time_per_percent: p.feedforward.map_or(0.0, |weight| weight / 100.0 / p.kv),
        takeover_window: p.takeover_window,
        takeover_way: p.takeover_way,
        mode_cycles: p.mode_timeout_cycles,
        start_cycles: p.mode_timeout_cycles + 2,
        brake_cycles: p.brake_timeout_cycles,
        position_mode: p.position_mode,
        velocity_mode: p.velocity_mode,
        velocity_scale: p.velocity_scale,
        velocity_range: process_data::Coeffs {
            lowest,
            highest,
            lower_limit: (f64::from(lowest) - 0.5).next_up(),
            upper_limit: (f64::from(highest) + 0.5).next_down(),
        },
        call_rate: Default::default(),
    }
}

/// The reference's inputs.
#[must_use]
pub fn inputs_of(of: &Inputs) -> spindle::Inputs<f64> {
    // The key cycle_counter has a model of its own.
    let mut inputs = spindle::Inputs::default();
    copy!(inputs = of:
        x_command, v_interpolator, x_actual, v_actual, s_word, s_position, m3, m4, m5, m19, putax, g74, job_done, drive_on,
        operation_mode_display, feedforward_active, feedforward_percentage, reset, task_cycle_ns);
    inputs
}

fn outputs_of(of: &spindle::Outputs<f64>) -> Outputs {
    Outputs {
        spindle_state: of.spindle_state as i32,
        loop_closed: of.loop_closed,
        x_spindle: of.x_spindle,
        v_spindle: of.v_spindle,
        operation_mode: of.operation_mode,
        velocity_command: of.velocity_command,
        job: of.job as i32,
        job_number: of.job_number,
        job_speed: of.job_speed,
        job_position: of.job_position,
        waiting: of.waiting,
        limited: of.limited,
        fault: of.fault,
        error_id: of.error_id,
    }
}
