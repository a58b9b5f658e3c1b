//! The exercise of a block: the run of `verify` on a user's own blocks, and its coverage.

mod boundaries;
pub mod coverage;
mod events;
mod sets;
mod spindle;
mod typed;

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
    // Later events override earlier ones.
    stimulus.event.splice(0..0, sets::other(designed, block));
    stimulus.event.extend(sets::damaged(&block.program));
    stimulus.event.extend(typed::events(designed, block));
    let mut partner = spindle::Machinery::of(designed, block);
    let partner = partner.as_mut().map(|partner| partner as &mut dyn Partner);
    let shape = Shape::of(&block.program.inputs, block.program.real);
    stimulus::answered(&stimulus, &shape, count, partner).unwrap_or_else(|mistake| panic!("exercise: {mistake}"))
}
