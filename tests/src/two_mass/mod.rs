//! Random position loops of two masses with the block `ipc` in them: whether they are stable, and how the watch over the loop answers. The
//! plant, the moves and what disturbs them are here; no rule of the watch.

mod random;
mod stimulus;

pub use random::{Cause, Loop};
pub use stimulus::Stimulus;

use crate::model::subject;
use generator::blocks;
use machine::{Machine, two_masses};
use portable::{Block, Portable, Real, RealKind};
use reference::ipc::{Coeffs, Ipc, Outputs, mode_on};

/// What a run showed.
#[derive(Clone, Copy, Debug, Default)]
pub struct Run {
    /// when the watch tripped [s]
    pub tripped: Option<f64>,
    /// when `v_add` was 0 for good [s]
    pub faded_out: Option<f64>,
    /// how long `v_add` stood at its limit, all in all [s]
    pub at_limit: f64,
    /// the same of the longest spell: one begins anew where `v_add` was off its limit for [`CALM`]
    pub spell: f64,
    /// largest |v_add| in the half second before the end, as a part of the limit
    pub left: f64,
}

/// Off the limit for so long [s], the loop has come back from what pushed it there.
const CALM: f64 = 0.1;

/// The coefficients that the generator designs for the block of a loop.
///
/// # Panics
/// If the generator refuses the set.
#[must_use]
pub fn coefficients<R: Real>(of: &Loop, kind: RealKind, watch: bool) -> Coeffs<R> {
    let designed = subject::read(&of.set(kind, watch));
    let mut all = blocks::named("ipc").expect("the registry has it").coefficients(&designed).into_iter();
    Portable::build(&mut || all.next().expect("all coefficients"))
}

/// A loop that runs: the block and the machine.
struct Running<R: Real> {
    coeffs: Coeffs<R>,
    state: <Ipc as Block<R>>::State,
    inputs: <Ipc as Block<R>>::Inputs,
    outputs: Outputs<R>,
    machine: two_masses::Running,
    /// the measured position of the cycle before [um]
    measured: f64,
}

impl<R: Real> Running<R> {
    fn new(of: &Loop, coeffs: Coeffs<R>) -> Self {
        let mut inputs = <Ipc as Block<R>>::inputs(&coeffs);
        inputs.mode = mode_on();
        let (state, outputs) = (<Ipc as Block<R>>::state(), <Ipc as Block<R>>::outputs());
        Self { coeffs, state, inputs, outputs, machine: of.machine.at_rest(), measured: 0.0 }
    }

    /// A cycle: measured position and commanded position [um], feedforward [um/s], forces on both masses [N].
    fn cycle(&mut self, of: &Loop, measured: f64, x: f64, v: f64, forces: [f64; 2]) {
        let v_motor = (measured - self.measured) / of.cycle();
        self.measured = measured;
        let v_command = of.kv * (x - measured) + v;
        (self.inputs.v_motor, self.inputs.v_command) = (R::lit(v_motor), R::lit(v_command));
        <Ipc as Block<R>>::step(&mut self.state, &self.coeffs, &self.inputs, &mut self.outputs);
        self.machine.forces = forces;
        self.machine.step((v_command + self.outputs.v_add.to_f64()) * 1e-6);
    }
}

/// How fast a swing of the loop grows without a limit [1/s], below 0: decays. By simulation, without the watch, from one push on.
#[must_use]
pub fn growth(of: &Loop) -> f64 {
    const FROM: f64 = 1e-3;
    const TO: f64 = 1e9;
    const SECONDS: f64 = 6.0;
    const PART: f64 = 0.25;
    let mut coeffs = coefficients::<f64>(of, RealKind::F64, false);
    (coeffs.limit, coeffs.lower_limit, coeffs.sum_limit, coeffs.rest) = (1e14, -1e14, 1e15, 0.0);
    (coeffs.fade_cycles, coeffs.fade_step) = (1, 1.0);
    let mut running = Running::new(of, coeffs);
    running.machine.push(FROM * 1e-6);
    let (mut peaks, mut peak, mut parts) = (Vec::new(), 0.0_f64, 1.0);
    for cycle in 1_u32.. {
        let time = f64::from(cycle) * of.cycle();
        let measured = running.machine.now().x * 1e6;
        running.cycle(of, measured, 0.0, 0.0, [0.0; 2]);
        let now = running.machine.now();
        peak = peak.max(now.v_motor.abs().max(now.v_load.abs()) * 1e6);
        if peak > TO {
            return (TO / FROM).ln() / time;
        }
        if time >= PART * parts {
            peaks.push(peak);
            (peak, parts) = (0.0, parts + 1.0);
        }
        if time >= SECONDS {
            break;
        }
    }
    // The last part against the middle one: what decays fast has gone by then.
    let (middle, last) = (peaks.len() / 2 - 1, peaks.len() - 1);
    let pair = |at: usize| peaks[at].max(peaks[at - 1]).ln();
    (pair(last) - pair(middle)) / (PART * (last - middle) as f64)
}

/// Runs a loop until so long after the trip, or to the end of the stimulus.
///
/// # Panics
/// If the block puts out a fault, or an id that does not fit `tripped`.
#[must_use]
pub fn run<R: Real>(of: &Loop, coeffs: Coeffs<R>, stimulus: &mut Stimulus, after: f64) -> Run {
    let limit = coeffs.limit.to_f64();
    let mut running = Running::new(of, coeffs);
    let mut shown = Run::default();
    let (mut x, mut spell, mut touched) = (0.0, 0.0, f64::NEG_INFINITY);
    for cycle in 0..stimulus.velocity.len() {
        let time = cycle as f64 * of.cycle();
        let v = stimulus.velocity[cycle];
        x += v * of.cycle();
        let measured = of.measure(running.machine.now().x * 1e6, stimulus);
        let forces = stimulus.forces(cycle);
        running.cycle(of, measured, x, v, forces);
        let (outputs, v_add) = (&running.outputs, running.outputs.v_add.to_f64().abs());
        assert!(
            !outputs.fault && outputs.error_id == if outputs.tripped { 5 } else { 0 },
            "{time} s: {}",
            outputs.error_id
        );
        if outputs.tripped {
            shown.tripped.get_or_insert(time);
            if v_add > 0.0 {
                shown.faded_out = None;
            } else {
                shown.faded_out.get_or_insert(time);
            }
        }
        if v_add >= limit {
            shown.at_limit += of.cycle();
            spell = of.cycle() + if time - touched > CALM { 0.0 } else { spell };
            shown.spell = shown.spell.max(spell);
            touched = time;
        }
        if shown.tripped.is_some_and(|tripped| time > tripped + after) {
            break;
        }
        if time > stimulus.seconds() - 0.5 {
            shown.left = shown.left.max(v_add / limit);
        }
    }
    shown
}
