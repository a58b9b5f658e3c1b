//! One random axis through the block `ipc` that stands alone and through its model: the first disagreement in words, and what was seen.

use super::axes::Drawn;
use super::block::Block;
use super::cycle::{Alone, Found};
use super::history::History;
use crate::random::rng::Rng;
use std::ops::AddAssign;

/// What was compared.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seen {
    /// cycles
    pub cycles: u64,
    /// flags and ids, and those of them that rounding leaves open
    pub flags: u64,
    /// those of them that rounding leaves open
    pub choices: u64,
    /// loops that the watch found unstable
    pub trips: u64,
    /// cycles with a sample that is ridden through
    pub held: u64,
    /// sets that were taken over
    pub taken: u64,
    /// cycles in which a set is refused, by its id 6, 7, 8
    pub refused: [u64; 3],
    /// sets that were dropped for a fault
    pub dropped: u64,
    /// cycles with an input that is not usable for tuning
    pub tuning: u64,
}

impl AddAssign for Seen {
    fn add_assign(&mut self, other: Self) {
        self.cycles += other.cycles;
        self.flags += other.flags;
        self.choices += other.choices;
        self.trips += other.trips;
        self.held += other.held;
        self.taken += other.taken;
        self.dropped += other.dropped;
        self.tuning += other.tuning;
        self.refused.iter_mut().zip(other.refused).for_each(|(refused, more)| *refused += more);
    }
}

/// Compares one axis for so many cycles.
///
/// # Errors
/// The first disagreement: the axis, the cycle, the signal, both values.
pub fn axis(seed: u64, index: usize, cycles: usize) -> Result<Seen, String> {
    let mut rng = Rng::numbered(seed, index);
    let drawn = Drawn::new(&mut rng);
    run(&drawn, rng, cycles).map_err(|text| format!("axis {index} of seed {seed}: {text}\n{}", drawn.parameters.set()))
}

fn run(drawn: &Drawn, rng: Rng, cycles: usize) -> Result<Seen, String> {
    let mut block = Block::new(&drawn.designed, &drawn.structure);
    let mut model = Alone::new(drawn);
    let mut history = History::new(drawn, rng);
    let mut seen = Seen::default();
    let (mut was_tripped, mut was_in_use) = (0.0_f64, 0.0_f64);
    let mut before = None;
    for cycle in 0..cycles {
        let given = history.advance();
        block.step(&given);
        let [v_add, calculated, error_id] = ["v_add", "v_add_calculated", "error_id"].map(|name| block.output(name));
        let [tripped, active_set] = ["tripped", "active_set"].map(|name| block.output(name));
        let is_one_of = |ids: &[f64]| ids.iter().any(|id| (id - error_id).abs() < 0.5);
        let found = Found {
            shown: if calculated == 0.0 { v_add } else { calculated },
            is_disturbed: is_one_of(&[3.0])
                || is_one_of(&[1.0, 11.0, 12.0, 13.0])
                    && block.output("held") == 0.0
                    && match drawn.parameters.tunable {
                        // No set stays in use after such a fault.
                        "all" => !model.has_set() || active_set == 0.0,
                        // A block without a fault before would have ridden through. Else its parts start anew: mostly the large sample that
                        // left it open is not a fault.
                        "weights" => !is_one_of(&[1.0]) && model.can_ride(),
                        _ => true,
                    },
            is_tripped: tripped > 0.0,
        };
        for (signal, [from, to]) in model.cycle(&given, found) {
            let value = block.output(signal);
            if !(from <= value && value <= to) {
                return Err(format!(
                    "cycle {cycle}, {signal}: the model has {from} to {to}, the reference {value}\n\
                     given {given:?}\nbefore {before:?}\noutputs {:?}\n{model:?}",
                    block.outputs()
                ));
            }
            if !signal.starts_with("v_add") {
                seen.flags += 1;
                seen.choices += u64::from(from < to);
            }
        }
        seen.cycles += 1;
        seen.trips += u64::from(tripped > was_tripped);
        seen.held += u64::from(block.output("held") > 0.0);
        seen.taken += u64::from(active_set > 0.0 && active_set.to_bits() != was_in_use.to_bits());
        seen.dropped += u64::from(active_set == 0.0 && was_in_use > 0.0);
        seen.tuning += u64::from(is_one_of(&[4.0]));
        for (refused, id) in seen.refused.iter_mut().zip([6.0, 7.0, 8.0]) {
            *refused += u64::from(is_one_of(&[id]));
        }
        (was_tripped, was_in_use) = (tripped, active_set);
        before = Some(given);
    }
    Ok(seen)
}
