//! Random histories: what the caller of a block gives it, cycle by cycle. No parameter but the cycle time and the real type.

use super::parameters::Parameters;
use crate::random::rng::Rng;

/// The inputs of all blocks in one cycle; reals are numbers of the block's real type.
#[derive(Clone, Copy, Debug)]
pub struct Inputs {
    pub x_command: f64,
    pub x_actual: f64,
    pub following_error: f64,
    pub v_interpolator: f64,
    pub a_interpolator: f64,
    pub j_interpolator: f64,
    pub v_motor: f64,
    pub v_direct: f64,
    pub v_add_master: f64,
    pub v_feedforward: f64,
    pub v_additive: f64,
    pub v_add: f64,
    /// `tuning_weight`
    pub tuning_weight: [f64; 3],
    pub tuning_limit: f64,
    pub torque_feedforward: i32,
    pub mode: i32,
    pub feedforward_active: bool,
    pub feedforward_percentage: i32,
    pub position_controlled: bool,
    pub reset: bool,
    pub task_cycle_ns: u32,
    pub cycle_counter: u32,
}

impl Inputs {
    /// At rest at 0, with everything on.
    pub const USUAL: Self = Self {
        x_command: 0.0,
        x_actual: 0.0,
        following_error: 0.0,
        v_interpolator: 0.0,
        a_interpolator: 0.0,
        j_interpolator: 0.0,
        v_motor: 0.0,
        v_direct: 0.0,
        v_add_master: 0.0,
        v_feedforward: 0.0,
        v_additive: 0.0,
        v_add: 0.0,
        tuning_weight: [1.0; 3],
        tuning_limit: 1.0,
        torque_feedforward: 0,
        mode: 1,
        feedforward_active: true,
        feedforward_percentage: 100,
        position_controlled: true,
        reset: false,
        task_cycle_ns: 0,
        cycle_counter: 0,
    };
}

/// How many reals there are.
const REALS: usize = 11;

/// How a real goes on.
#[derive(Clone, Copy, Debug)]
enum Motion {
    Rest,
    Constant(f64),
    Ramp(f64, f64),
    Noise(f64),
}

/// A source of cycles.
#[derive(Clone, Debug)]
pub struct History {
    rng: Rng,
    single: bool,
    cycle_ns: u32,
    /// events in 1000 cycles, of each kind
    events: usize,
    /// a phase's motions, and how many cycles are left of it
    motions: [Motion; REALS],
    left: usize,
    switches: Inputs,
    /// of an axis that counts: how the counter goes on, the counter, irregular calls in 1000
    calls: Option<(Rng, u32, usize)>,
}

impl History {
    /// Of an axis; every set has its own.
    #[must_use]
    pub fn new(p: &Parameters, mut rng: Rng) -> Self {
        let events = *rng.pick(&[0, 2, 10, 60]);
        let switches = Inputs::USUAL;
        let motions = [Motion::Rest; REALS];
        let calls = p.counts_calls.then(|| {
            let mut own = rng.clone();
            let irregular = *own.pick(&[5, 30, 110, 250]);
            (own, 0, irregular)
        });
        Self { rng, single: p.single, cycle_ns: p.cycle_ns, events, motions, left: 0, switches, calls }
    }

    /// The next cycle.
    pub fn advance(&mut self) -> Inputs {
        if self.left == 0 {
            self.begin_phase();
        }
        self.left -= 1;
        let mut reals = self.motions.map(|_| 0.0);
        for (real, motion) in reals.iter_mut().zip(&mut self.motions) {
            *real = match motion {
                Motion::Rest => 0.0,
                Motion::Constant(value) => *value,
                Motion::Ramp(value, slope) => {
                    *value += *slope;
                    *value
                }
                Motion::Noise(scale) => uniform(&mut self.rng) * *scale,
            };
        }
        // The actual position stays near its command.
        reals[1] += reals[0];
        let single = self.single;
        let lag = reals[0] - reals[1];
        let mut following_error = if self.rng.below(1000) < self.events / 4 { bad(&mut self.rng, single) } else { lag };
        if single {
            following_error = narrowed(following_error);
        }
        for real in &mut reals {
            if self.rng.below(1000) < self.events / 4 {
                *real = bad(&mut self.rng, single);
            }
            if single {
                *real = narrowed(*real);
            }
        }
        let mut inputs = self.switches;
        if self.rng.below(1000) < self.events {
            inputs.reset = true;
        }
        if self.rng.below(1000) < self.events {
            inputs.position_controlled = false;
        }
        if self.rng.below(1000) < self.events {
            inputs.task_cycle_ns = *self.rng.pick(&[1, self.cycle_ns + 1, self.cycle_ns - 1, u32::MAX]);
        }
        if self.rng.below(1000) < self.events {
            inputs.mode = *self.rng.pick(&[-1, 3, i32::MAX, i32::MIN]);
        }
        for factor in inputs.tuning_weight.iter_mut().chain([&mut inputs.tuning_limit]) {
            if self.rng.below(1000) < self.events / 4 {
                *factor = *self.rng.pick(&[f64::NAN, f64::INFINITY, -0.5, 1.5, 1e30]);
            }
        }
        let [x_command, x_actual, v_interpolator, a_interpolator, j_interpolator, v_motor, ..] = reals;
        let [.., v_direct, v_add_master, v_feedforward, v_additive, v_add] = reals;
        if let Some((rng, counter, irregular)) = &mut self.calls {
            let is_regular = rng.below(1000) >= *irregular;
            let more = if is_regular { 1 } else { *rng.pick(&[0, 0, 2, 2, 2, 3, 3, 4, 5, 100, u32::MAX]) };
            *counter = counter.wrapping_add(more);
            if rng.below(1000) < 3 {
                *counter = *rng.pick(&[0, 1, u32::MAX - 2, u32::MAX]);
            }
            inputs.cycle_counter = *counter;
        }
        Inputs {
            x_command,
            x_actual,
            following_error,
            v_interpolator,
            a_interpolator,
            j_interpolator,
            v_motor,
            v_direct,
            v_add_master,
            v_feedforward,
            v_additive,
            v_add,
            ..inputs
        }
    }

    fn begin_phase(&mut self) {
        let rng = &mut self.rng;
        self.left = rng.between(3, 90);
        // x, lag, v, a, j, then velocities
        const SCALES: [f64; REALS] = [1e6, 1e3, 3e5, 3e6, 1e8, 3e5, 3e5, 3e5, 3e5, 3e5, 1e5];
        let at_rest = rng.chance(15);
        for (motion, scale) in self.motions.iter_mut().zip(SCALES) {
            let factor = if rng.chance(3) { 1e4 } else { 10f64.powf(-2.0 * uniform(rng).abs()) };
            let value = uniform(rng) * scale * factor;
            *motion = match rng.below(4) {
                _ if at_rest => Motion::Rest,
                0 => Motion::Constant(value),
                1 => Motion::Ramp(value, uniform(rng) * scale * 0.01),
                2 => Motion::Noise(scale * factor),
                // On a grid of whole numbers, where ties are.
                _ => Motion::Constant(value.round()),
            };
        }
        let switches = &mut self.switches;
        switches.torque_feedforward = (i32::try_from(rng.word() >> 33).expect("31 bits") - (1 << 30)) >> rng.below(20);
        // A mode lasts longer than the fade needs in some phases, and shorter in others.
        if rng.chance(40) {
            switches.mode = *rng.pick(&[0, 1, 1, 1, 2]);
        }
        for factor in switches.tuning_weight.iter_mut().chain([&mut switches.tuning_limit]) {
            if rng.chance(15) {
                let any = narrowed(uniform(rng).abs());
                *factor = *rng.pick(&[0.0, 1.0, 0.5, any, any, 1e-7]);
            }
        }
        if rng.chance(30) {
            switches.feedforward_active = !switches.feedforward_active;
        }
        if rng.chance(40) {
            let any = i32::try_from(rng.between(0, 400)).expect("small") - 150;
            switches.feedforward_percentage = *rng.pick(&[100, 100, any, any, 101, 0, -1, i32::MAX, i32::MIN]);
        }
        switches.position_controlled = !rng.chance(4);
        switches.reset = rng.chance(3);
        switches.task_cycle_ns = if rng.chance(50) { 0 } else { self.cycle_ns };
    }
}

/// Uniform in -1 to 1, with 53 random bits.
pub fn uniform(rng: &mut Rng) -> f64 {
    (rng.word() >> 11) as f64 / 2f64.powi(52) - 1.0
}

/// A number of single precision.
#[expect(clippy::cast_possible_truncation, reason = "a number of the block's real type")]
pub fn narrowed(real: f64) -> f64 {
    f64::from(real as f32)
}

/// A number that is none, or the last one that is.
pub fn bad(rng: &mut Rng, single: bool) -> f64 {
    let largest = if single { 1e9 } else { 1e15 };
    let beyond = if single { 1_000_000_064.0 } else { 1_000_000_000_000_000.1 };
    *rng.pick(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, beyond, -beyond, 1e30, largest, -largest])
}
