//! Proposals for random axes, tried in a run: none is unstable or beyond its limit, and what is predicted is what is
//! left. A vibration that enters at the load gets a proposal only if the sensor says that it enters at the motor, and
//! then it gets no worse.

use crate::by_depth;
use crate::plant::{CYCLE, Impulse, random_axis};
use crate::proposals::{Truth, measured, proposed, stages, tried};
use crate::{stage::response, what_if::VIBRATIONS};
use identification::Complex64;
use identification::proposals::{Proposal, Refused};
use identification::source::{Side, side};
use machine::mechanics::Mechanics;
use machine::plant::{DEMONSTRATION, Plant};
use std::f64::consts::{PI, TAU};

/// Noise of `v_motor` [m/s]: 0.1 mm/s, and 30 % of the amplitude of the excitation.
const NOISE: [f64; 2] = [0.1e-3, 1.5e-3];

/// A random axis with the mesh of the demonstration plant.
fn axis(seed: u64) -> Plant {
    let axis = random_axis(seed);
    Plant { mechanics: Mechanics { mesh: DEMONSTRATION.mechanics.mesh, ..axis.mechanics }, ..axis }
}

/// What is predicted, by the truth.
#[derive(Default)]
struct Statistics {
    proposals: usize,
    refused: usize,
    /// of the residual, and of the following error: prediction by truth less 1
    residual: Vec<f64>,
    error: Vec<f64>,
    /// the largest |S| in truth: nominal, 15 % less load, 15 % more
    ms: [f64; 3],
    /// axes on which a source at the load is taken for one at the motor, and the largest part that is left of it then
    taken_for_motor: usize,
    worst_at_load: f64,
}

impl Statistics {
    fn add(&mut self, plant: &Plant, truths: &[Truth; 3], proposal: &Proposal) {
        self.proposals += 1;
        for (largest, truth) in self.ms.iter_mut().zip(truths) {
            *largest = largest.max(truth.ms(&proposal.stages, 0.0));
        }
        let truth = tried(plant, proposal);
        self.residual.push(proposal.prediction.left.residuals[0] / truth[0] - 1.0);
        self.error.push(proposal.prediction.effect.following_error.unwrap() / truth[3] - 1.0);
        if let Some(left) = left_at_load(plant, truths, proposal) {
            self.taken_for_motor += 1;
            self.worst_at_load = self.worst_at_load.max(left);
        }
    }

    fn shown(&self, noise: f64) -> String {
        let [residual, error] = [&self.residual, &self.error].map(|of| quantiles(of));
        format!(
            "noise {:.1} mm/s: {} proposals, {} axes refused; residual: 95 % within {:.3}, worst {:.3}; following error: {:.3}, {:.3}; \
             Ms {:.3?}; at the load: {} taken for the motor's, left at most {:.3}",
            noise * 1e3,
            self.proposals,
            self.refused,
            residual[0],
            residual[1],
            error[0],
            error[1],
            self.ms,
            self.taken_for_motor,
            self.worst_at_load
        )
    }
}

/// The 95th percentile and the largest of sizes.
fn quantiles(of: &[f64]) -> [f64; 2] {
    let mut sizes: Vec<f64> = of.iter().map(|value| value.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    [sizes.len() * 95 / 100, sizes.len() - 1].map(|k| sizes[k.min(sizes.len() - 1)])
}

/// What stages leave of an error of the mesh that acts between motor and load, where the sensor says that it enters
/// at the motor; none: it says that it does not. By the equations of the plant, its velocity loop continuous, with
/// the true P.
fn left_at_load(plant: &Plant, truths: &[Truth; 3], proposal: &Proposal) -> Option<f64> {
    let Plant { mechanics: m, kp, tn, drive_cycle, .. } = *plant;
    let hz = VIBRATIONS[0].hz;
    let s = Complex64::new(0.0, TAU * hz);
    let contact = m.k1 + s * m.c1;
    let way = 1.0 / (s * s * m.m2) + 1.0 / (s * s * m.m3 + s * m.c2 + m.k2);
    let stiffness = contact / (1.0 + contact * way);
    let held = (-s * drive_cycle / 2.0).exp() / (1.0 + s * m.current_lag);
    let own = s * s * m.m1 + kp * (1.0 + 1.0 / (s * tn)) * held * s;
    // Way of the motor by the error of the mesh, the loop open: -stiffness/(own + stiffness); the contact shortens by both.
    let moved = -stiffness / (own + stiffness);
    let (moving, excited) = (stiffness * (1.0 + 1.0 / moved) / s, stiffness / s);
    if side(moving, excited) == Side::Load {
        return None;
    }
    let (position, p) = truths[0].at(hz);
    let c: Complex64 =
        proposal.stages.iter().map(|(shape, weight)| response(shape, CYCLE)((PI * hz * CYCLE).tan()) * *weight).sum();
    let contact = |c: Complex64| (1.0 + moved / (1.0 + position - c * p)).norm();
    Some(contact(c) / contact(Complex64::from(0.0)))
}

#[test]
#[expect(clippy::print_stdout, reason = "the statistics are what a reader of the run wants")]
fn proposals_for_random_axes() {
    let (axes, noises, least) = by_depth((8..9, &NOISE[..1], 0), (0..10, &NOISE[..1], 0), (0..100, &NOISE[..], 101));
    let mut all: Vec<Statistics> = noises.iter().map(|_| Statistics::default()).collect();
    for seed in axes {
        let plant = axis(seed);
        let truths =
            [1.0, 0.85, 1.15].map(|factor| Truth::of(&Impulse::of_cycles(&plant.with_mass_factor(factor), 8192)));
        for (noise, statistics) in noises.iter().zip(&mut all) {
            let lines = measured(&plant, *noise);
            match proposed(&lines, &plant, *noise, &VIBRATIONS[..1], &stages) {
                Ok(found) => found.iter().for_each(|proposal| {
                    statistics.add(&plant, &truths, proposal);
                }),
                Err(Refused::TooUncertain(_)) => statistics.refused += 1,
                Err(refused) => panic!("axis {seed}: {refused:?}"),
            }
        }
    }
    for (statistics, noise) in all.iter().zip(noises) {
        let shown = statistics.shown(*noise);
        println!("{shown}");
        let ([usual, worst], [of_error, _]) = (quantiles(&statistics.residual), quantiles(&statistics.error));
        assert!(statistics.ms.iter().all(|ms| *ms < 2.1), "{shown}");
        assert!(usual < 0.07 && worst < 0.2 && of_error < 0.05, "{shown}");
        assert!(statistics.worst_at_load <= 1.0, "{shown}");
        assert!(statistics.proposals >= least, "{shown}");
    }
}
