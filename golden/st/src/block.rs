//! A function block, checked and lowered: plain data. What reads, runs or changes it is elsewhere.

use super::op::Op;
use super::variables::Variables;

/// A `FUNCTION_BLOCK`, checked and lowered.
#[derive(Clone, Debug)]
pub struct Block {
    /// its name
    pub(crate) name: String,
    /// its variables, and the slots
    pub(crate) variables: Variables,
    /// a cycle
    pub(crate) ops: Vec<Op>,
    /// where it begins, for mistakes of a run
    pub(crate) place: (usize, usize),
}
