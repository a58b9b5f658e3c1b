//! A block against the model: the same inputs, every output of every cycle. No formula is here.

use super::motion::{TURN, is_velocity, near};
use super::{Inputs, Model, Outputs, Parameters, history};

/// Of reals, relative to the largest of a turn and the value.
const TOLERANCE: f64 = 1e-9;
/// Of a time by which a position leads [s]: what is left where T takes T away.
const ROUNDING: f64 = 3e-17;

/// Runs a block through a random history.
///
/// # Errors
/// The first difference: the cycle, the signal, both values, the last inputs.
pub fn agree(p: &Parameters, seed: u64, cycles: usize, block: impl FnMut(&Inputs) -> Outputs) -> Result<(), String> {
    compare(p, &history(seed, cycles, p), block).map_err(|text| format!("seed {seed}: {text}"))
}

/// Runs a block through any history.
///
/// # Errors
/// As [`agree`].
pub fn compare(p: &Parameters, history: &[Inputs], mut block: impl FnMut(&Inputs) -> Outputs) -> Result<(), String> {
    let mut model = Model::new(p);
    let mut before = Outputs::START;
    // A sample of 1e15 leads by its rounding alone.
    let mut lead = 0f64;
    for (cycle, inputs) in history.iter().enumerate() {
        let (expected, found) = (model.cycle(inputs), block(inputs));
        if is_velocity(inputs.v_actual) {
            lead = lead.max(inputs.v_actual.abs() * ROUNDING);
        }
        if let Some(text) = difference(p, &expected, &found, lead) {
            let last: String =
                history[cycle.saturating_sub(3)..=cycle].iter().map(|of| format!("\n  {of:?}")).collect();
            return Err(format!(
                "cycle {cycle}: {text}\nbefore {before:?}\nmodel  {expected:?}\nblock  {found:?}\nlast inputs{last}\n{p:?}"
            ));
        }
        before = expected;
    }
    Ok(())
}

/// The first signal that differs, with the model's value and the block's. Positions may differ by `lead` more.
#[must_use]
pub fn difference(p: &Parameters, expected: &Outputs, found: &Outputs, lead: f64) -> Option<String> {
    let (e, f) = (expected, found);
    let integer = |name, e: i64, f: i64| (e != f).then(|| format!("{name}: the model has {e}, the block {f}"));
    let flag = |name, e: bool, f: bool| (e != f).then(|| format!("{name}: the model has {e}, the block {f}"));
    let real = |name, e: f64, f: f64, distance: f64, scale: f64| {
        // A distance that is not a number is a difference.
        let is_near = distance <= TOLERANCE * scale.abs().max(TURN);
        (!is_near).then(|| format!("{name}: the model has {e:?}, the block {f:?}"))
    };
    let plain = |name, e: f64, f: f64| real(name, e, f, (e - f).abs(), e);
    // Both on the circle and not beyond it; a fast spindle's position is a sum of its steps.
    let is_on_circle = (0.0..TURN).contains(&f.x_spindle);
    let angle = if is_on_circle { near(e.x_spindle - f.x_spindle).abs() } else { f64::NAN };
    integer("spindle_state", e.spindle_state.into(), f.spindle_state.into())
        .or_else(|| integer("error_id", e.error_id.into(), f.error_id.into()))
        .or_else(|| flag("fault", e.fault, f.fault))
        .or_else(|| flag("loop_closed", e.loop_closed, f.loop_closed))
        .or_else(|| plain("v_spindle", e.v_spindle, f.v_spindle))
        .or_else(|| real("x_spindle", e.x_spindle, f.x_spindle, angle - lead, e.v_spindle))
        .or_else(|| integer("job", e.job.into(), f.job.into()))
        .or_else(|| integer("job_number", e.job_number.into(), f.job_number.into()))
        .or_else(|| plain("job_speed", e.job_speed, f.job_speed))
        .or_else(|| plain("job_position", e.job_position, f.job_position))
        .or_else(|| integer("waiting", e.waiting.into(), f.waiting.into()))
        .or_else(|| {
            // Outputs that a block with position control in the CNC does not have.
            if p.in_cnc {
                return None;
            }
            integer("operation_mode", e.operation_mode.into(), f.operation_mode.into())
                .or_else(|| integer("velocity_command", e.velocity_command.into(), f.velocity_command.into()))
                .or_else(|| flag("limited", e.limited, f.limited))
        })
}
