//! Random histories of the block `ipc` that stands alone: velocities that swing, grow and die away around the limit, bad samples in a row, what
//! a caller switches, parameter sets at any moment.

use super::axes::Drawn;
use super::damage::{absent, damaged, zeros};
use super::set::Set;
use crate::model::history::{Inputs, bad, narrowed, uniform};
use crate::random::rng::Rng;
use std::f64::consts::TAU;
use std::rc::Rc;

/// The inputs of one cycle.
#[derive(Clone, Debug)]
pub struct Given {
    /// what the blocks have in common
    pub inputs: Inputs,
    /// input `v_command`
    pub v_command: f64,
    /// input `params`
    pub offered: Rc<Set>,
}

/// How a velocity goes on.
#[derive(Clone, Copy, Debug)]
enum Motion {
    Constant(f64),
    Ramp(f64, f64),
    Noise(f64),
    /// amplitude, growth in a cycle, angle, its step
    Swing([f64; 4]),
}

/// A source of cycles.
pub struct History<'d> {
    of: &'d Drawn,
    rng: Rng,
    /// events in 1000 cycles, of each kind; changes of what is offered
    events: usize,
    offers: usize,
    motions: [Motion; 3],
    left: usize,
    /// bad samples to come of each velocity
    bad: [usize; 3],
    switches: Inputs,
    offered: Rc<Set>,
    /// cycles until what is offered changes again, and until a blow
    offer_in: usize,
    blow_in: usize,
}

/// A velocity that no axis has, in range: the sum is a fault.
const BLOW: f64 = 3e8;

impl<'d> History<'d> {
    /// Of an axis.
    #[must_use]
    pub fn new(of: &'d Drawn, mut rng: Rng) -> Self {
        let events = *rng.pick(&[0, 1, 4, 20]);
        let offers = *rng.pick(&[2, 10, 50]);
        let structure = &of.structure;
        let mut offered = zeros(structure);
        if !of.sets.is_empty() {
            let whole = &of.sets[rng.below(of.sets.len())];
            match rng.below(4) {
                0 => {}
                1 => offered = absent(whole),
                2 => offered = damaged(whole, &of.sets[0], structure, &mut rng),
                _ => offered = whole.clone(),
            }
        }
        let switches = Inputs { mode: *rng.pick(&[0, 1, 1, 2]), ..Inputs::USUAL };
        let (motions, bad, offered) = ([Motion::Constant(0.0); 3], [0; 3], Rc::new(offered));
        Self { of, rng, events, offers, motions, left: 0, bad, switches, offered, offer_in: 0, blow_in: 0 }
    }

    /// The next cycle.
    pub fn advance(&mut self) -> Given {
        if self.left == 0 {
            self.begin_phase();
        }
        self.left -= 1;
        let single = self.of.parameters.single;
        let rng = &mut self.rng;
        let mut velocities = [0.0; 3];
        for ((velocity, motion), bad_left) in velocities.iter_mut().zip(&mut self.motions).zip(&mut self.bad) {
            *velocity = match motion {
                Motion::Constant(value) => *value,
                Motion::Ramp(value, slope) => {
                    *value += *slope;
                    *value
                }
                Motion::Noise(scale) => uniform(rng) * *scale,
                Motion::Swing([amplitude, growth, angle, step]) => {
                    *amplitude *= *growth;
                    *angle += *step;
                    *amplitude * angle.sin()
                }
            };
            if *bad_left == 0 && rng.below(1000) < self.events {
                *bad_left = rng.between(1, 4);
            }
            if *bad_left > 0 {
                *bad_left -= 1;
                *velocity = bad(rng, single);
            }
            if single {
                *velocity = narrowed(*velocity);
            }
        }
        let mut inputs = self.switches;
        inputs.reset |= rng.below(2000) < self.events;
        inputs.position_controlled &= rng.below(2000) >= self.events;
        if rng.below(2000) < self.events {
            let cycle_ns = self.of.parameters.cycle_ns;
            inputs.task_cycle_ns = *rng.pick(&[1, cycle_ns + 1, cycle_ns - 1, u32::MAX]);
        }
        if rng.below(2000) < self.events {
            inputs.mode = *rng.pick(&[-1, 3, i32::MAX, i32::MIN]);
        }
        for factor in inputs.tuning_weight.iter_mut().chain([&mut inputs.tuning_limit]) {
            if rng.below(1000) < self.events {
                *factor = *rng.pick(&[f64::NAN, f64::INFINITY, -0.5, 1.5, 1e30]);
            }
        }
        let has_sets = !self.of.sets.is_empty();
        self.offer_in = self.offer_in.saturating_sub(1);
        if has_sets && (self.offer_in == 1 || self.rng.below(1000) < self.offers) {
            self.offer();
        }
        // A set in use is dropped for a blow; what was offered may be another one by then.
        self.blow_in = self.blow_in.saturating_sub(1);
        if self.blow_in == 1 || self.rng.below(3000) < self.offers {
            velocities = [BLOW; 3];
            if has_sets && self.rng.chance(50) {
                self.repair();
            }
        }
        let [v_command, v_motor, v_direct] = velocities;
        Given { inputs: Inputs { v_motor, v_direct, ..inputs }, v_command, offered: Rc::clone(&self.offered) }
    }

    /// Another set, or another content of the one that is offered.
    fn offer(&mut self) {
        let Drawn { sets, structure, .. } = self.of;
        let rng = &mut self.rng;
        let whole = &sets[rng.below(sets.len())];
        let other = &sets[rng.below(sets.len())];
        match rng.below(8) {
            0..=3 => self.offered = Rc::new(whole.clone()),
            4 | 5 => self.offered = Rc::new(damaged(whole, other, structure, rng)),
            // While a block fades out for it.
            6 => {
                let set_id = self.offered.set_id;
                let same = sets.iter().find(|set| set.set_id == set_id).unwrap_or(whole);
                self.offered = Rc::new(Set { set_id, ..damaged(same, other, structure, rng) });
            }
            _ => self.repair(),
        }
        // While it is checked or refused; and while the block fades out for it, after its check.
        let check = structure.check_cycles();
        match self.rng.below(4) {
            0 => self.offer_in = self.rng.between(2, 100),
            1 => self.offer_in = check + self.rng.between(2, 40),
            2 => self.blow_in = self.rng.between(2, 100),
            _ => {}
        }
    }

    /// What is offered becomes the whole set of that number, or any.
    fn repair(&mut self) {
        let sets = &self.of.sets;
        let kept = self.offered.set_id;
        let whole = sets.iter().find(|set| set.set_id == kept);
        let any = &sets[self.rng.below(sets.len())];
        self.offered = Rc::new(whole.unwrap_or(any).clone());
    }

    fn begin_phase(&mut self) {
        let rng = &mut self.rng;
        let p = &self.of.parameters;
        let limit = f64::from(p.v_add_max_fact) / 1000.0 * f64::from(p.vb_max);
        let cycle = f64::from(p.cycle_ns) * 1e-9;
        self.left = rng.between(3, 150);
        for motion in &mut self.motions {
            // From a thousandth of the limit up to ten times the limit, and the velocities that an axis has.
            let scale = limit * 10f64.powf(2.0 * uniform(rng) - 1.0);
            let stage = &p.stages[rng.below(p.stages.len())];
            let step = TAU * stage.band_pass.2 * cycle * (1.0 + 0.3 * uniform(rng));
            let block = (0.03 / cycle).max(8.0);
            *motion = match rng.below(8) {
                0 => Motion::Constant(if rng.chance(50) { 0.0 } else { scale }),
                1 => Motion::Ramp(scale, scale * 0.01 * uniform(rng)),
                2 => Motion::Noise(scale),
                // By up to a half in a block of the watch, or as it is.
                3 => Motion::Swing([scale, 1.0, 0.0, step]),
                _ => Motion::Swing([scale, (0.4 * uniform(rng) / block).exp(), 0.0, step]),
            };
        }
        // What the watch must see, and what it must leave alone: a swing that grows for as long as it takes, from below the limit.
        let grows = p.watch && rng.chance(15);
        if grows {
            let block = (0.03 / cycle).max(8.0);
            let growth = (0.12 + 0.5 * uniform(rng).abs()) / block;
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few hundred cycles")]
            let cycles = (12.0 * block) as usize;
            self.left = cycles;
            let scale = limit * 10f64.powf(-0.7 - uniform(rng).abs());
            let stage = &p.stages[0];
            let step = TAU * stage.band_pass.2 * cycle;
            self.motions = [Motion::Swing([scale, growth.exp(), 0.0, step]); 3];
        }
        let switches = &mut self.switches;
        if grows {
            switches.mode = 1;
        } else if rng.chance(25) {
            switches.mode = *rng.pick(&[0, 1, 1, 1, 2]);
        }
        for factor in switches.tuning_weight.iter_mut().chain([&mut switches.tuning_limit]) {
            if rng.chance(15) {
                let any = narrowed(uniform(rng).abs());
                *factor = *rng.pick(&[0.0, 1.0, 1.0, 0.5, any, 1e-7, f64::NAN]);
            }
        }
        switches.position_controlled = !rng.chance(3);
        switches.reset = rng.chance(3);
        switches.task_cycle_ns = if rng.chance(50) { 0 } else { p.cycle_ns };
    }
}
