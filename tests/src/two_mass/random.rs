//! Random loops: the machine, and the stages of the block, right ones and wrong ones. Nothing is run here.

use super::stimulus::Stimulus;
use crate::random::rng::Rng;
use machine::two_masses::TwoMasses;
use portable::RealKind;
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// What may be wrong with a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// weights up to the cap
    Weight,
    /// up to ten cycles of delay, which turn the sign
    Delay,
    /// a centre frequency far next to the resonance
    Frequency,
    /// nothing is
    None,
}

/// A stage.
#[derive(Clone, Copy, Debug)]
struct Stage {
    /// damping ratio of an INDIRECT stage; none: DIRECT
    damping: Option<f64>,
    order: usize,
    f0: f64,
    q: f64,
    /// in hundredths
    weight: u32,
}

/// A loop.
#[derive(Clone, Debug)]
pub struct Loop {
    /// what may be wrong
    pub cause: Cause,
    /// mechanics, drive, cycle time, delay
    pub machine: TwoMasses,
    /// gain of the position controller [1/s]
    pub kv: f64,
    /// largest velocity [um/s]
    pub vb_max: u32,
    /// largest acceleration [um/s^2]
    pub acceleration: f64,
    /// limit [0.1 %]
    v_add_max_fact: u32,
    stages: Vec<Stage>,
    /// increment of the encoder, and its noise [um]
    increment: f64,
    noise: f64,
}

/// Between two numbers; equally often in each of their powers.
pub fn between(rng: &mut Rng, from: f64, to: f64) -> f64 {
    from * (to / from).powf(rng.below(10_001) as f64 / 1e4)
}

/// About the normal distribution, variance 1.
pub fn normal(rng: &mut Rng) -> f64 {
    (0..12).map(|_| rng.below(10_001) as f64 / 1e4).sum::<f64>() - 6.0
}

impl Loop {
    /// A random one.
    #[must_use]
    pub fn random(rng: &mut Rng) -> Self {
        let cause = *rng.pick(&[Cause::Weight, Cause::Delay, Cause::Frequency, Cause::None, Cause::None, Cause::None]);
        let cycle_ns = *rng.pick(&[500_000, 1_000_000, 1_000_000, 2_000_000]);
        let (total, ratio) = (between(rng, 100.0, 3000.0), between(rng, 0.3, 3.0));
        let mass = [total / (1.0 + ratio), total * ratio / (1.0 + ratio)];
        // Of the load with a locked motor, and of both masses against each other.
        let locked = between(rng, 12.0, 80.0);
        let free = locked * (1.0 + mass[1] / mass[0]).sqrt();
        let stiffness = (TAU * locked).powi(2) * mass[1];
        let damping = 2.0 * between(rng, 0.01, 0.08) * (stiffness * mass[1]).sqrt();
        let gain = total * TAU * between(rng, 30.0, 80.0);
        let integral_gain = gain / between(rng, 0.015, 0.05);
        let mut stages: Vec<Stage> = Vec::new();
        for resonance in [locked, free].into_iter().take(rng.between(1, 2)) {
            let off =
                if cause == Cause::Frequency && stages.is_empty() { *rng.pick(&[0.6, 0.7, 1.5, 1.8]) } else { 1.0 };
            let f0 = (off * resonance * between(rng, 0.9, 1.1)).min(0.3e9 / f64::from(cycle_ns));
            // Stages that overlap are another matter.
            if stages.iter().all(|other| (other.f0 / f0).ln().abs() > 0.4) {
                stages.push(Stage::random(rng, cause, f0));
            }
        }
        let delay_cycles = if cause == Cause::Delay { rng.between(2, 10) } else { rng.between(1, 2) };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 1e6")]
        let [vb_max, v_add_max_fact] = [between(rng, 1e5, 1e6), between(rng, 50.0, 300.0)].map(|of| of as u32);
        Self {
            cause,
            machine: TwoMasses { mass, stiffness, damping, gain, integral_gain, cycle_ns, delay_cycles },
            kv: between(rng, 10.0, 30.0),
            vb_max,
            acceleration: between(rng, 0.5e6, 5e6),
            v_add_max_fact,
            stages,
            increment: between(rng, 1e-3, 1.0),
            noise: between(rng, 1e-3, 0.3),
        }
    }

    /// The same without stages' effect: whether the loop is good before improved position control comes.
    #[must_use]
    pub fn bare(&self) -> Self {
        let stages = self.stages.iter().map(|stage| Stage { weight: 1, ..*stage }).collect();
        Self { stages, ..self.clone() }
    }

    /// Cycle time [s].
    #[must_use]
    pub fn cycle(&self) -> f64 {
        f64::from(self.machine.cycle_ns) / 1e9
    }

    /// Lowest and highest f0 [Hz].
    #[must_use]
    pub fn frequencies(&self) -> [f64; 2] {
        let all = || self.stages.iter().map(|stage| stage.f0);
        [all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max)]
    }

    /// The limit [um/s].
    #[must_use]
    pub fn limit(&self) -> f64 {
        f64::from(self.vb_max) * f64::from(self.v_add_max_fact) / 1000.0
    }

    /// The mass of both [kg].
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.machine.mass.iter().sum()
    }

    /// A position as the encoder shows it [um].
    #[must_use]
    pub fn measure(&self, x: f64, stimulus: &mut Stimulus) -> f64 {
        let noise = if stimulus.has_noise { self.noise * normal(&mut stimulus.rng) } else { 0.0 };
        ((x + noise) / self.increment).round() * self.increment
    }

    /// The set of the axis X.
    #[must_use]
    pub fn set(&self, kind: RealKind, watch: bool) -> String {
        let real = if kind == RealKind::F64 { "f64" } else { "f32" };
        let mut text = format!(
            "cycle_time = '{}ns'\n[axis.X]\nreal = '{real}'\nwatch = {watch}\ngetriebe = [{{ dynamik.vb_max = {} }}]\n\
             [axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = {}\n",
            self.machine.cycle_ns, self.vb_max, self.v_add_max_fact
        );
        for Stage { damping, order, f0, q, weight } in &self.stages {
            let mode = match damping {
                Some(damping) => format!("mode = 'INDIRECT'\nosc_damping = {damping:.6}"),
                None => "mode = 'DIRECT'".to_owned(),
            };
            let _ = write!(
                text,
                "[[axis.X.lr_param.improved_position_control.stage]]\n{mode}\nweight_fact_num = {weight}\n\
                 weight_fact_denom = 100\nfilter = [{{ order = {order}, fg_f0 = {f0:.6}, q_factor = {q:.6} }}]\n"
            );
        }
        text
    }
}

impl Stage {
    fn random(rng: &mut Rng, cause: Cause, f0: f64) -> Self {
        let [least, most] = match cause {
            Cause::Weight => [200.0, 700.0],
            Cause::Delay | Cause::Frequency => [100.0, 700.0],
            Cause::None => [30.0, 300.0],
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 700")]
        let weight = between(rng, least, most) as u32;
        let (q, order) = (*rng.pick(&[1.5, 2.0, 3.0, 5.0, 10.0]), rng.between(1, 3));
        Self { damping: rng.chance(40).then(|| between(rng, 0.4, 0.9)), order, f0, q, weight }
    }
}
