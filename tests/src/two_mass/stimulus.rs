//! What happens to a loop: moves, blows, chatter, noise. No loop here.

use super::random::{Loop, between};
use crate::random::rng::Rng;
use std::f64::consts::TAU;

/// A burst of chatter: a force on the motor that rings with its own frequency.
#[derive(Clone, Copy, Debug)]
struct Burst {
    at: usize,
    amplitude: f64,
    frequency: f64,
    decay: f64,
}

/// A run's excitation.
#[derive(Clone, Debug)]
pub struct Stimulus {
    /// velocity of the interpolator, cycle by cycle [um/s]
    pub velocity: Vec<f64>,
    /// whether the encoder has noise
    pub has_noise: bool,
    /// what the noise comes from
    pub rng: Rng,
    cycle: f64,
    /// force on the load from a cycle on [N]
    steps: Vec<(usize, f64)>,
    bursts: Vec<Burst>,
}

impl Stimulus {
    /// Rest for so long, with noise.
    #[must_use]
    pub fn rest(of: &Loop, rng: &Rng, seconds: f64) -> Self {
        let velocity = vec![0.0; cycles(of, seconds)];
        let (steps, bursts) = (Vec::new(), Vec::new());
        Self { velocity, has_noise: true, rng: rng.clone(), cycle: of.cycle(), steps, bursts }
    }

    /// Moves to and fro, with ramps of the acceleration; every one to two seconds a force that comes or goes, and a burst of chatter.
    #[must_use]
    pub fn random(of: &Loop, rng: &mut Rng, seconds: f64) -> Self {
        let mut made = Self::rest(of, rng, seconds);
        made.moves(of, rng);
        let mut at = cycles(of, 0.5);
        let mut force = 0.0;
        while at < made.velocity.len() {
            if rng.chance(50) {
                let largest = 0.5 * of.mass() * of.acceleration * 1e-6;
                force = if force == 0.0 { *rng.pick(&[-1.0, 1.0]) * between(rng, 0.1, 1.0) * largest } else { 0.0 };
                made.steps.push((at, force));
            } else {
                let [lowest, _] = of.frequencies();
                let factor = between(rng, 0.1, 1.5);
                made.burst(of, at, lowest * between(rng, 0.8, 1.2), factor, between(rng, 0.03, 0.2));
            }
            at += cycles(of, between(rng, 0.5, 2.0));
        }
        made
    }

    /// Adds moves, and their pauses.
    fn moves(&mut self, of: &Loop, rng: &mut Rng) {
        let (a, v_max, all) = (of.acceleration, f64::from(of.vb_max), self.velocity.len());
        let mut raw = vec![0.0; cycles(of, 0.3)];
        let mut sign = 1.0;
        while raw.len() < all {
            let way = v_max * v_max / a * between(rng, 0.1, 3.0);
            let top = (a * way).sqrt().min(v_max);
            let ramp = cycles(of, top / a).max(1);
            let constant = cycles(of, (way / top - top / a).max(0.0));
            let part = |n: usize| sign * top * (n as f64 + 0.5) / ramp as f64;
            raw.extend((0..ramp).map(part));
            raw.extend(std::iter::repeat_n(sign * top, constant));
            raw.extend((0..ramp).rev().map(part));
            raw.extend(std::iter::repeat_n(0.0, cycles(of, between(rng, 0.1, 1.0)) + 1));
            if rng.chance(70) {
                sign = -sign;
            }
        }
        self.velocity = smooth(&raw[..all], cycles(of, between(rng, 0.02, 0.06)).max(1));
    }

    /// One move over so many times the way that the largest velocity needs, from a time on [s].
    pub fn one_move(&mut self, of: &Loop, at: f64, ways: f64) {
        let (a, v_max, all) = (of.acceleration, f64::from(of.vb_max), self.velocity.len());
        let ramp = cycles(of, v_max / a).max(1);
        let constant = cycles(of, (ways - 1.0).max(0.0) * v_max / a);
        let mut raw = vec![0.0; cycles(of, at)];
        raw.extend((0..ramp).map(|n| v_max * (n as f64 + 0.5) / ramp as f64));
        raw.extend(std::iter::repeat_n(v_max, constant));
        raw.extend((0..ramp).rev().map(|n| v_max * (n as f64 + 0.5) / ramp as f64));
        raw.resize(all, 0.0);
        self.velocity = smooth(&raw[..all], cycles(of, 0.02).max(1));
    }

    /// A force on the load that stays, as a part of what the largest acceleration needs.
    pub fn blow(&mut self, of: &Loop, at: f64, part: f64) {
        self.steps.push((cycles(of, at), part * of.mass() * of.acceleration * 1e-6));
    }

    /// A burst of chatter from a cycle on: so many times the force that swings the free masses as fast as the limit, decaying in so long.
    pub fn burst(&mut self, of: &Loop, at: usize, frequency: f64, limits: f64, decay: f64) {
        let amplitude = limits * of.limit() * 1e-6 * of.mass() * TAU * frequency * 0.5;
        self.bursts.push(Burst { at, amplitude, frequency, decay });
    }

    /// Forces on motor and load [N].
    #[must_use]
    pub fn forces(&self, cycle: usize) -> [f64; 2] {
        let of_burst = |burst: &Burst| {
            let time = cycle.checked_sub(burst.at).map(|cycles| cycles as f64 * self.cycle);
            let swing = |t: f64| burst.amplitude * (-t / burst.decay).exp() * (TAU * burst.frequency * t).sin();
            time.map_or(0.0, swing)
        };
        let step = self.steps.iter().rev().find(|(at, _)| *at <= cycle).map_or(0.0, |(_, force)| *force);
        [self.bursts.iter().map(of_burst).sum(), step]
    }

    /// How long it lasts.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.velocity.len() as f64 * self.cycle
    }
}

/// A time in cycles.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a minute at most")]
fn cycles(of: &Loop, seconds: f64) -> usize {
    (seconds / of.cycle()) as usize
}

/// The mean of the last so many values: ramps of the acceleration.
fn smooth(raw: &[f64], length: usize) -> Vec<f64> {
    let mut sum = 0.0;
    let mean = |n: usize| {
        sum += raw[n] - if n >= length { raw[n - length] } else { 0.0 };
        sum / length as f64
    };
    (0..raw.len()).map(mean).collect()
}
