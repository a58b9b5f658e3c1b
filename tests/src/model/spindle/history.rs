//! Random histories of the inputs: an interpolator, a drive and a person, closed over the model. No formula of the block is here.

use super::drives::{Drive, uniform};
use super::interpolator::{Interpolator, bad};
use super::motion::TURN;
use super::{Inputs, Model, Outputs, POSITION, Parameters, TO_VELOCITY};
use crate::random::rng::Rng;
use std::collections::VecDeque;

/// The inputs of so many cycles.
#[must_use]
pub fn history(seed: u64, cycles: usize, p: &Parameters) -> Vec<Inputs> {
    let mut source = Source::new(p, Rng::new(seed));
    let mut model = Model::new(p);
    let mut block = Outputs::START;
    (0..cycles)
        .map(|_| {
            let inputs = source.advance(p, &block);
            block = model.cycle(&inputs);
            inputs
        })
        .collect()
}

/// What a person presses in one cycle.
#[derive(Clone, Copy, Debug)]
struct Press {
    /// m3, m4, m5, m19, putax, g74
    levels: [bool; 6],
    s_word: f64,
    s_position: f64,
    /// cycles for which it stays
    held: usize,
}

struct Source {
    rng: Rng,
    drive: Drive,
    interpolator: Interpolator,
    /// mistakes in 1000 cycles, of each kind
    mistakes: usize,
    /// the same of a wrong cycle, in the first one
    wrong_cycles: usize,
    /// cycles between two requests
    gap: usize,
    presses: VecDeque<Press>,
    /// cycles until the drive has another habit
    left: usize,
    /// a sample that is none for some cycles: which, what, how long
    gone: Option<(usize, f64, usize)>,
    last: Inputs,
}

impl Source {
    fn new(p: &Parameters, mut rng: Rng) -> Self {
        let (drive, interpolator) = (Drive::new(p, &mut rng), Interpolator::new(p, &mut rng));
        let mistakes = *rng.pick(&[0, 0, 2, 10, 40, 150]);
        let wrong_cycles = if rng.chance(8) { 40_000 } else { 0 };
        let gap = *rng.pick(&[10, 40, 100, 200]);
        let last = Inputs { drive_on: true, ..Inputs::START };
        let left = rng.below(400);
        Self { rng, drive, interpolator, mistakes, wrong_cycles, gap, presses: VecDeque::new(), left, gone: None, last }
    }

    fn advance(&mut self, p: &Parameters, block: &Outputs) -> Inputs {
        let rng = &mut self.rng;
        if self.left == 0 {
            self.drive.change(p, rng);
            self.left = rng.between(10, 10 * usize::try_from(p.mode_timeout_cycles).expect("small") + 400);
        }
        self.left -= 1;
        if rng.below(200) == 0 {
            self.last.feedforward_active = rng.chance(70);
            self.last.feedforward_percentage = *rng.pick(&[100, 100, 50, 33, 0, 140, -7, i32::MAX, i32::MIN]);
            self.last.task_cycle_ns = *rng.pick(&[0, p.cycle_ns]);
        }
        let drive = self.drive.advance(p, block, &self.last, rng);
        let interpolator = self.interpolator.advance(p, block, rng);
        self.request(p);
        let rng = &mut self.rng;
        let mut inputs = Inputs {
            x_command: interpolator.x,
            v_interpolator: interpolator.v,
            x_actual: drive.x,
            v_actual: drive.v,
            job_done: interpolator.done,
            drive_on: drive.is_on,
            operation_mode_display: drive.mode,
            ..self.last
        };
        if let Some(press) = self.presses.front_mut() {
            [inputs.m3, inputs.m4, inputs.m5, inputs.m19, inputs.putax, inputs.g74] = press.levels;
            (inputs.s_word, inputs.s_position) = (press.s_word, press.s_position);
            press.held = press.held.saturating_sub(1);
            if press.held == 0 {
                self.presses.pop_front();
            }
        }
        // A spindle with an error, or with a job that does not end, waits for somebody who comes.
        let resets = match block.waiting {
            _ if block.fault => 30,
            4 => 15,
            _ if changes(p, block) => 6 * self.mistakes.min(3) + 1,
            _ => self.mistakes.min(3) + 1,
        };
        inputs.reset = rng.below(1000) < resets || (self.last.reset && rng.chance(60));
        self.last.reset = inputs.reset;
        self.mistake(p, block, &mut inputs);
        inputs
    }

    fn mistake(&mut self, p: &Parameters, block: &Outputs, inputs: &mut Inputs) {
        let (rng, mistakes, wrong_cycles) = (&mut self.rng, self.mistakes, &mut self.wrong_cycles);
        let samples = [
            &mut inputs.x_command,
            &mut inputs.v_interpolator,
            &mut inputs.x_actual,
            &mut inputs.v_actual,
            &mut inputs.s_word,
            &mut inputs.s_position,
        ];
        let more = usize::from(block.spindle_state != POSITION || changes(p, block)) * 2 * mistakes;
        for sample in samples {
            if rng.below(4000) < mistakes + more {
                *sample = bad(p, rng);
            }
        }
        if self.gone.is_none() && rng.below(12_000) < mistakes + more {
            let value = *rng.pick(&[f64::NAN, f64::INFINITY, -1.1e15]);
            self.gone = Some((rng.below(4), value, rng.between(1, 6)));
        }
        if let Some((which, value, left)) = self.gone {
            match which {
                0 => inputs.x_command = value,
                1 => inputs.v_interpolator = value,
                2 => inputs.x_actual = value,
                _ => inputs.v_actual = value,
            }
            self.gone = (left > 1).then_some((which, value, left - 1));
            if self.gone.is_none() && rng.chance(30) {
                self.interpolator.jump(p, rng);
            }
        }
        // An error that stays: rarely.
        if rng.below(40_000) < mistakes + *wrong_cycles {
            *wrong_cycles = 0;
            inputs.task_cycle_ns = *rng.pick(&[1, p.cycle_ns + 1, p.cycle_ns - 1, u32::MAX]);
        }
        // More often while no other request has a place.
        let full = usize::from(block.waiting == 4) * 20 * mistakes;
        if rng.below(8000) < mistakes + more + full {
            inputs.drive_on = false;
        }
        if rng.below(4000) < mistakes {
            inputs.job_done = !inputs.job_done;
        }
    }

    /// Presses something, now and then.
    fn request(&mut self, p: &Parameters) {
        let rng = &mut self.rng;
        if !self.presses.is_empty() || rng.below(self.gap) != 0 {
            return;
        }
        let mut held = [false; 6];
        for _ in 0..*rng.pick(&[1, 1, 1, 2, 6]) {
            let mut press = press(p, rng);
            // One is pressed while others are held.
            press.levels.iter_mut().zip(held).for_each(|(level, held)| *level |= held);
            let released = Press { levels: [false; 6], held: rng.between(1, 3), ..press };
            self.presses.push_back(press);
            held = if rng.chance(20) { press.levels } else { released.levels };
            if held == released.levels {
                self.presses.push_back(released);
            }
        }
    }
}

/// Short: the spindle turns for a change of the mode, or changes it.
fn changes(p: &Parameters, block: &Outputs) -> bool {
    block.spindle_state == TO_VELOCITY
        || block.spindle_state == POSITION && block.job == 1 && block.v_spindle.abs() > 0.98 * p.v_on
}

fn press(p: &Parameters, rng: &mut Rng) -> Press {
    const M3: [bool; 6] = [true, false, false, false, false, false];
    const M4: [bool; 6] = [false, true, false, false, false, false];
    const M3_M4: [bool; 6] = [true, true, false, false, false, false];
    const M5: [bool; 6] = [false, false, true, false, false, false];
    const M19: [bool; 6] = [false, false, false, true, false, false];
    const M19_M3: [bool; 6] = [true, false, false, true, false, false];
    const M19_M4: [bool; 6] = [false, true, false, true, false, false];
    const PUTAX: [bool; 6] = [false, false, false, false, true, false];
    const G74: [bool; 6] = [false, false, false, false, false, true];
    let usual = [M3, M3, M3, M3, M4, M4, M4, M4, M3_M4, M5, M19, M19_M3, M19_M4, PUTAX, G74];
    let any = std::array::from_fn(|_| rng.chance(40));
    let fast = if p.v_on > 0.0 { p.v_on } else { 600_000.0 };
    let other = uniform(rng) * 3.0;
    let factor = *rng.pick(&[0.3, 1.0, 1.1, 1.5, 1.5, 2.0, 1.2, -1.7, 1.05, other]);
    Press {
        levels: if rng.chance(15) { any } else { *rng.pick(&usual) },
        s_word: if rng.chance(6) { bad(p, rng) } else { factor * fast },
        s_position: if rng.chance(6) { bad(p, rng) } else { uniform(rng) * 2.0 * TURN },
        held: *rng.pick(&[1, 1, 2, 5, 100]),
    }
}
