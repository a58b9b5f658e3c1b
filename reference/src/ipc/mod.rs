//! Improved position control: up to three stages, their sum, the limit, the fade, and the reactions to faults, reset and loss of
//! position control.
//!
//! ```text
//! v_sum            = v_stage[0] + v_stage[1] + v_stage[2]
//! v_add_calculated = v_sum, limited to +-limit
//! v_add            = fade * v_add_calculated
//! ```
//!
//! The fade moves linearly between 0 and 1 within `fade_cycles` cycles: up while the mode is ON, down while it is
//! DRYRUN or OFF. A fault, a reset or the loss of position control sets it to 0 at once. When the block starts from fade 0,
//! the sections start from the steady state of the present input, so that the output does not jump.

pub mod numbers;
pub mod ride_through;
mod signals;
mod sources;
pub mod tuning;
pub mod watch;

pub use signals::{Inputs, Outputs, STAGES};
pub(crate) use signals::{inputs, outputs};
pub use signals::{mode_dryrun, mode_off, mode_on};

pub use sources::simulates;

use self::sources::{are_in_range, reads_command, reads_direct, reads_motor};
use crate::call_rate;
use crate::signal::{
    error_call_rate, error_cycle_time, error_gantry_slave, error_mode, error_none, error_state, error_unstable,
};
use crate::signal::{error_tuning, error_v_command, error_v_direct, error_v_motor, sample_limit};
use crate::stage;
use crate::sum::empty_sum;
use portable::{Block, Enable, Off, Real, from_u32, in_range, note, portable, within};
use tuning::are_followed;

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// cycle time that all coefficients were designed for [ns]
    pub cycle_time_ns: u32,
    /// start value of the input mode: 0 OFF, 1 ON, 2 DRYRUN
    pub enable: i32,
    /// TRUE: the axis is a gantry slave, which gets its master's additive velocity (P-AXIS-00070)
    pub slave: bool,
    /// the stages
    pub stage: [stage::Coeffs<R>; STAGES],
    /// largest |v_add| [um/s or 0.001 deg/s]
    pub limit: R,
    /// -limit [um/s or 0.001 deg/s]
    pub lower_limit: R,
    /// largest magnitude of the sum of the stages; a larger sum is a fault [um/s or 0.001 deg/s]
    pub sum_limit: R,
    /// a sum up to this magnitude is set to 0, so that the output at rest is exactly 0
    pub rest: R,
    /// length of the fade from 0 to 1 [cycles]
    pub fade_cycles: u32,
    /// 1 / fade_cycles
    pub fade_step: R,
    /// bad samples in a row
    pub ride_through: ride_through::Coeffs,
    /// what the caller tunes
    pub tuning: tuning::Coeffs<R>,
    /// the watch over the loop
    pub watch: watch::Coeffs<R>,
    /// the rate of the calls
    pub call_rate: call_rate::Coeffs,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// TRUE after the filter sections have been preset to the steady state of the input
    pub preset: bool,
    /// position of the fade [cycles]: 0 off, fade_cycles fully on, above fade_cycles: a state was corrupted
    pub fade: u32,
    /// the rate of the calls
    pub call_rate: call_rate::State,
    /// bad samples in a row
    pub ride_through: ride_through::State,
    /// what the caller tunes
    pub tuning: tuning::State<R>,
    /// the watch over the loop
    pub watch: watch::State<R>,
    /// the velocities of the previous cycle
    pub source: sources::State<R>,
    /// the sections of each stage
    pub stage: [stage::State<R>; STAGES],
}

/// Presets all sections to the steady state of the present input.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) {
    sources::preset(&mut state.source, &coeffs.stage, coeffs.ride_through.active, inputs);
    for i in 0..STAGES {
        if coeffs.stage[i].mode != stage::Mode::NotActive {
            let x = stage::source(&coeffs.stage[i], inputs.v_command, inputs.v_motor, inputs.v_direct);
            stage::preset(&mut state.stage[i], &coeffs.stage[i], x);
        }
    }
}

/// Runs all stages; returns the sum of their outputs.
#[portable]
pub fn sum_of_stages<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> R {
    let mut changes = sources::Changes::<R>::default();
    sources::step(&mut state.source, &coeffs.stage, coeffs.ride_through.active, inputs, &mut changes);
    let mut v_sum = empty_sum();
    for i in 0..STAGES {
        if coeffs.stage[i].mode != stage::Mode::NotActive {
            let x = stage::source(&coeffs.stage[i], inputs.v_command, inputs.v_motor, inputs.v_direct);
            let change = stage::source(&coeffs.stage[i], changes.v_command, changes.v_motor, changes.v_direct);
            let v_stage = stage::step(&mut state.stage[i], &coeffs.stage[i], x, change);
            if coeffs.tuning.active {
                let v_tuned = v_stage * state.tuning.weight[i].now;
                v_sum = v_sum + v_tuned;
            } else {
                v_sum = v_sum + v_stage;
            }
        }
    }
    v_sum
}

/// Moves the fade by one cycle: up while the mode is ON, down otherwise. In OFF the block stops when the fade reaches 0.
#[portable]
pub fn move_fade<R: Real>(state: &mut State<R>, mode: i32) {
    if mode == mode_on() {
        // The fade is below fade_cycles here: the usual cycle handles the full fade.
        state.fade += 1u32;
    } else if state.fade > 1u32 {
        state.fade -= 1u32;
    } else {
        state.fade = 0u32;
        if mode == mode_off() {
            state.preset = false;
        }
    }
}

/// A state was corrupted. The fade is set above fade_cycles, as if the fade itself were corrupted, so that the next cycle
/// reports the fault. The tuning factors restart.
#[portable]
pub fn disturb<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    if coeffs.tuning.active {
        tuning::init(&mut state.tuning);
    }
    state.fade = coeffs.fade_cycles + 1u32;
}

/// The block must not act: it restarts afterwards.
#[portable]
pub fn stop<R: Real>(state: &mut State<R>) {
    state.preset = false;
    state.fade = 0u32;
}

/// The upper limit of the sum, scaled by the tuning factor.
#[portable]
pub fn tuned_limit<R: Real>(coeffs: &Coeffs<R>, tuning: &tuning::State<R>) -> R {
    if coeffs.tuning.active { coeffs.limit * tuning.limit.now } else { coeffs.limit }
}

/// The lower limit of the sum, scaled by the tuning factor.
#[portable]
pub fn tuned_lower_limit<R: Real>(coeffs: &Coeffs<R>, tuning: &tuning::State<R>) -> R {
    // A product instead of 0 - x: compiler options that ignore the sign of 0 must not change the result.
    if coeffs.tuning.active { coeffs.lower_limit * tuning.limit.now } else { coeffs.lower_limit }
}

/// Whether the scaled upper limit is at most the limit: the tuning factor may have been corrupted.
#[portable]
pub fn is_limit<R: Real>(coeffs: &Coeffs<R>, upper: R) -> bool {
    !coeffs.tuning.active || in_range(upper, coeffs.limit)
}

/// The sum within +-limit; exactly 0 if its magnitude is at most `rest`. A sum above `sum_limit` is a fault: a state was
/// corrupted, or an input is far above P-AXIS-00212.
#[portable]
pub fn limit<R: Real>(state: &mut State<R>, outputs: &mut Outputs<R>, coeffs: &Coeffs<R>, v_sum: R) -> R {
    let upper = tuned_limit(coeffs, &state.tuning);
    if within(v_sum, upper) && (!coeffs.tuning.active || within(v_sum, coeffs.limit)) {
        if within(v_sum, coeffs.rest) { R::ZERO } else { v_sum }
    } else if within(v_sum, coeffs.sum_limit) && is_limit(coeffs, upper) {
        outputs.limited = true;
        if v_sum > R::ZERO { upper } else { tuned_lower_limit(coeffs, &state.tuning) }
    } else {
        note(
            "a state was corrupted, or an input is far above P-AXIS-00212: the next cycle reports the fault, then the block restarts",
        );
        outputs.limited = true;
        disturb(state, coeffs);
        R::ZERO
    }
}

/// Sets v_add to 0.
#[portable]
pub fn clear<R: Real>(outputs: &mut Outputs<R>, error_id: u32) {
    outputs.v_add = R::ZERO;
    outputs.v_add_calculated = R::ZERO;
    outputs.limited = false;
    outputs.fault = error_id != error_none();
    outputs.error_id = error_id;
}

/// Before the first cycle. The sections need nothing: the first active cycle presets them to their steady state.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    call_rate::init(&mut state.call_rate);
    ride_through::init(&mut state.ride_through);
    tuning::init(&mut state.tuning);
    watch::init(&mut state.watch);
    stop(state);
}

/// A cycle in which the sections run, after the fade has been moved. `is_tuning_held`: a tuning input is invalid.
#[portable]
pub fn act<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    outputs: &mut Outputs<R>,
    is_tuning_held: bool,
) {
    outputs.limited = false;
    outputs.fault = false;
    outputs.error_id = if is_tuning_held { error_tuning() } else { error_none() };
    // `limit` may set it above fade_cycles.
    let fade = state.fade;
    let v_sum = sum_of_stages(state, coeffs, inputs);
    let v_limited = limit(state, outputs, coeffs, v_sum);
    if fade < coeffs.fade_cycles {
        outputs.v_add = if fade > 0u32 { v_limited * (from_u32::<R>(fade) * coeffs.fade_step) } else { R::ZERO };
        outputs.v_add_calculated = if inputs.mode == mode_off() { R::ZERO } else { v_limited };
    } else {
        // With a full fade the mode is ON.
        outputs.v_add = v_limited;
        outputs.v_add_calculated = v_limited;
    }
    // Only a velocity that is added can make the loop unstable. A sum that is a fault is not a vibration.
    if coeffs.watch.active && inputs.mode == mode_on() && !state.watch.tripped && state.fade <= coeffs.fade_cycles {
        look_after(state, coeffs, v_sum);
    }
}

/// Passes the sum and the active limits to the watch.
#[portable]
pub fn look_after<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v_sum: R) {
    let upper = tuned_limit(coeffs, &state.tuning);
    let lower = tuned_lower_limit(coeffs, &state.tuning);
    if upper > R::ZERO {
        watch::step(&mut state.watch, &coeffs.watch, v_sum, upper, lower);
    } else {
        watch::restart(&mut state.watch);
    }
}

/// Fast path of `act`: mode ON, fade complete, tuning settled.
#[portable]
pub fn act_in_full<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    outputs.limited = false;
    outputs.fault = false;
    outputs.error_id = error_none();
    let v_sum = sum_of_stages(state, coeffs, inputs);
    let v_limited = limit(state, outputs, coeffs, v_sum);
    outputs.v_add = v_limited;
    outputs.v_add_calculated = v_limited;
    if coeffs.watch.active && state.fade <= coeffs.fade_cycles {
        look_after(state, coeffs, v_sum);
    }
}

/// Rearms the watch if the mode is not ON or reset is TRUE.
#[portable]
#[expect(
    clippy::collapsible_if,
    reason = "the first condition is decided for each axis, and takes the second one away"
)]
pub fn rearm<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, mode: i32, reset: bool) {
    // Checked first, so that the order of constants stays the same in a block without a watch.
    if coeffs.watch.active {
        if mode != mode_on() || reset {
            watch::init(&mut state.watch);
        }
    }
}

/// Moves the fade, or starts the block. Returns whether the sections run in this cycle. The first cycle presets them to the
/// steady state of the input; its output is 0, so that they need not run. Nor need they in the cycle that ends the fade in OFF.
#[portable]
pub fn prepare<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    let mut runs = false;
    if state.preset {
        // A tripped block behaves as in DRYRUN.
        if coeffs.watch.active && state.watch.tripped {
            move_fade(state, mode_dryrun());
        } else {
            move_fade(state, inputs.mode);
        }
        runs = state.preset;
    } else {
        // Nothing acts yet, whatever the memory says.
        state.fade = 0u32;
        if inputs.mode != mode_off() {
            preset(state, coeffs, inputs);
            state.preset = true;
            if coeffs.watch.active {
                watch::restart(&mut state.watch);
            }
        }
    }
    runs
}

/// Whether the mode is OFF, ON or DRYRUN.
#[portable]
pub fn is_mode(mode: i32) -> bool {
    mode == mode_on() || mode == mode_off() || mode == mode_dryrun()
}

/// Whether the caller's cycle time is the designed one, or unchecked (0).
#[portable]
pub fn is_cycle_time<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    inputs.task_cycle_ns == 0u32 || inputs.task_cycle_ns == coeffs.cycle_time_ns
}

/// Checks the call rate. After a pause the block restarts.
#[portable]
pub fn count_call<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, cycle_counter: u32) {
    if coeffs.call_rate.active {
        let has_paused = call_rate::step(&mut state.call_rate, cycle_counter);
        // A corrupted state is reported first.
        if has_paused && state.fade <= coeffs.fade_cycles {
            stop(state);
        }
    }
}

/// Stops the block for this reason; returns the reason.
#[portable]
pub fn refuse<R: Real>(state: &mut State<R>, reason: u32) -> u32 {
    stop(state);
    reason
}

/// Whether the axis is ON, in position control, not in reset and not a gantry slave: with a full fade only the sections change
/// then.
#[portable]
pub fn is_on<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    inputs.position_controlled && !inputs.reset && !coeffs.slave && inputs.mode == mode_on()
}

/// Whether samples and cycle time are valid and the axis is ON.
#[portable]
pub fn may_act_in_full<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    are_in_range(&coeffs.stage, inputs) && is_cycle_time(coeffs, inputs) && is_on(coeffs, inputs)
}

/// Whether the mode is ON, the fade is full, and every encoder sample that a stage uses is in range.
#[portable]
pub fn is_settled<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, mode: i32, v_motor: R, v_direct: R) -> bool {
    mode == mode_on()
        && state.fade == coeffs.fade_cycles
        && (!reads_motor(&coeffs.stage) || in_range(v_motor, sample_limit()))
        && (!reads_direct(&coeffs.stage) || in_range(v_direct, sample_limit()))
}

/// One cycle. A block with tuning inputs starts with the fast path: tuning is settled, and only the sections change. It has
/// the same result as `any_cycle`, with fewer conditions.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if coeffs.tuning.active {
        if may_act_in_full(coeffs, inputs)
            && call_rate::is_usual(&state.call_rate, &coeffs.call_rate, inputs.cycle_counter)
            && state.fade == coeffs.fade_cycles
            && !(coeffs.watch.active && state.watch.tripped)
            && (!coeffs.ride_through.active || state.ride_through.bad == 0u32)
            && are_followed(&state.tuning, &coeffs.tuning, &coeffs.stage, inputs)
        {
            note("the fast path: the mode is ON, the fade is full, and the factors have reached their inputs");
            outputs.held = false;
            call_rate::go_on(&mut state.call_rate, &coeffs.call_rate, inputs.cycle_counter);
            act_in_full(state, coeffs, inputs, outputs);
            tell_trip(state, coeffs, outputs);
        } else {
            note("any other cycle: the start, a fade, a change of a factor, a fault");
            any_cycle(state, coeffs, inputs, outputs);
        }
    } else {
        any_cycle(state, coeffs, inputs, outputs);
    }
}

/// Any cycle. Only the inputs that a stage uses are checked.
#[portable]
pub fn any_cycle<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    rearm(state, coeffs, inputs.mode, inputs.reset);
    count_call(state, coeffs, inputs.cycle_counter);
    go_on(state, coeffs, inputs, outputs);
}

/// The rest of the cycle, after the watch has been rearmed.
#[portable]
pub fn go_on<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if coeffs.ride_through.active {
        let mut replaced = Inputs::<R>::default();
        outputs.held = ride_through::replace(
            &mut state.ride_through,
            &coeffs.ride_through,
            &coeffs.stage,
            &state.source,
            state.preset && state.fade <= coeffs.fade_cycles && inputs.position_controlled && !inputs.reset,
            inputs,
            &mut replaced,
        );
        cycle(state, coeffs, &replaced, outputs);
    } else {
        outputs.held = false;
        cycle(state, coeffs, inputs, outputs);
    }
}

/// One cycle with these samples.
#[portable]
pub fn cycle<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let mut is_tuning_held = false;
    if coeffs.tuning.active && !are_followed(&state.tuning, &coeffs.tuning, &coeffs.stage, inputs) {
        let jumps = state.fade == 0u32 || state.fade > coeffs.fade_cycles;
        is_tuning_held = tuning::step(&mut state.tuning, &coeffs.stage, coeffs.fade_step, jumps, inputs);
    }
    // If there are several reasons not to act, the first is reported. The usual cycle comes before the rare ones, so the
    // cycle time is checked in two places.
    let mut runs = false;
    let mut reason = error_none();
    if reads_command(&coeffs.stage) && !in_range(inputs.v_command, sample_limit()) {
        reason = refuse(state, error_v_command());
    } else if reads_motor(&coeffs.stage) && !in_range(inputs.v_motor, sample_limit()) {
        reason = refuse(state, error_v_motor());
    } else if reads_direct(&coeffs.stage) && !in_range(inputs.v_direct, sample_limit()) {
        reason = refuse(state, error_v_direct());
    } else if is_on(coeffs, inputs) && state.fade == coeffs.fade_cycles && !(coeffs.watch.active && state.watch.tripped)
    {
        if !is_cycle_time(coeffs, inputs) {
            reason = refuse(state, error_cycle_time());
        } else if call_rate::is_wrong(&state.call_rate, &coeffs.call_rate) {
            reason = refuse(state, error_call_rate());
        } else {
            runs = true;
        }
    } else if !is_cycle_time(coeffs, inputs) {
        reason = refuse(state, error_cycle_time());
    } else if call_rate::is_wrong(&state.call_rate, &coeffs.call_rate) {
        reason = refuse(state, error_call_rate());
    } else if state.fade > coeffs.fade_cycles {
        reason = refuse(state, error_state());
    } else if !is_mode(inputs.mode) {
        reason = refuse(state, error_mode());
    } else if coeffs.slave && inputs.mode != mode_off() {
        reason = refuse(state, error_gantry_slave());
    } else if inputs.position_controlled && !inputs.reset {
        runs = prepare(state, coeffs, inputs);
    } else {
        stop(state);
    }
    if runs {
        act(state, coeffs, inputs, outputs, is_tuning_held);
    } else {
        clear(outputs, reason);
        if is_tuning_held && reason == error_none() {
            outputs.error_id = error_tuning();
        }
    }
    tell_trip(state, coeffs, outputs);
}

/// Reports whether the watch has tripped; its id is shown only if there is no fault.
#[portable]
pub fn tell_trip<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    outputs.tripped = coeffs.watch.active && state.watch.tripped;
    if coeffs.watch.active && state.watch.tripped && !outputs.fault {
        outputs.error_id = error_unstable();
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct Ipc;

impl<R: Real> Block<R> for Ipc {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = "ipc";
    const FRACTIONS: &'static [&'static str] = tuning::INPUTS;

    fn enable(_: &Coeffs<R>) -> Option<Enable> {
        Some(Enable { input: "mode", off: Off::Mode(&mode_off::Ir::<R>::IR, "preset") })
    }

    fn is_usual_first(coeffs: &Coeffs<R>) -> bool {
        coeffs.tuning.active
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs {
            mode: coeffs.enable,
            position_controlled: true,
            tuning_weight: coeffs.tuning.weight,
            tuning_limit: coeffs.tuning.limit,
            ..Inputs::default()
        }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.mode = mode_on();
        (inputs.tuning_weight, inputs.tuning_limit) = ([R::ONE; STAGES], R::ONE);
    }
}
