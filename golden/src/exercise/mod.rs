//! The exercise of a block: what `verify` runs a user's own blocks with, and how much of the block it reached.
//!
//! ```text
//! boundaries events at the boundaries of process data
//! events     moves, vibrations, noise, disturbances: nothing answers to them
//! spindle    the partner of a spindle: an operator, an interpolator, a drive
//! sets       the supplier of parameter sets: another one, also damaged, late or absent
//! coverage   what moved, what changed, which states, transitions and sets were reached
//! ```

mod boundaries;
pub mod coverage;
mod events;
mod sets;
mod spindle;

use crate::samples::{Samples, Shape};
use crate::stimulus::{self, Partner};
use generator::blocks::{Block, Designed};

/// The inputs of a block, sample by sample.
///
/// # Panics
/// If the stimulus does not fit the block: a defect of axgen.
#[must_use]
pub fn inputs(designed: &Designed, block: &Block, count: usize) -> Samples {
    let mut stimulus = events::stimulus(&designed.axis, &block.program);
    // The later events are the stronger ones.
    stimulus.event.splice(0..0, sets::other(designed, block));
    stimulus.event.extend(sets::damaged(&block.program));
    let mut partner = spindle::Machinery::of(designed, block);
    let partner = partner.as_mut().map(|partner| partner as &mut dyn Partner);
    let shape = Shape::of(&block.program.inputs, designed.axis.real);
    stimulus::answered(&stimulus, &shape, count, partner).unwrap_or_else(|mistake| panic!("exercise: {mistake}"))
}
