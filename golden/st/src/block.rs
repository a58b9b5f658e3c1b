//! A function block, checked and lowered: plain data. Reading, running and changing it is elsewhere.

use super::op::Op;
use super::structure::Structure;
use super::variables::Variables;
use std::ops::Range;

/// A `FUNCTION_BLOCK`, checked and lowered.
#[derive(Clone, Debug)]
pub struct Block {
    pub(crate) name: String,
    /// its variables, and the slots
    pub(crate) variables: Variables,
    /// the types of its structures
    pub(crate) structures: Vec<Structure>,
    /// the operations of a cycle
    pub(crate) ops: Vec<Op>,
    /// the operations of each assignment, in the order of the text
    pub(crate) assignments: Vec<Range<usize>>,
    /// its place, for errors of a run
    pub(crate) place: (usize, usize),
}
