//! The numbers of the excitation on a commissioning page: what it does to the machine, how long it takes. No text of steps.

use crate::axis::Axis;

/// What the page says of the excitation of an axis.
pub(super) struct Excite {
    /// bits and clock, as `--excitation` reads them
    pub(super) sequence: String,
    /// [s]
    pub(super) seconds: String,
    pub(super) fade: String,
    /// the slowest move while exciting, in the unit of the page
    pub(super) speed: String,
    /// what the axis travels at that speed, with its unit
    pub(super) path: String,
    /// what the excitation does to the machine
    pub(super) facts: Vec<Fact>,
}

/// A row of the table.
pub(super) struct Fact {
    pub(super) what: &'static str,
    pub(super) value: String,
}

impl Excite {
    /// `None` if the axis does not have the block `excitation`.
    pub(super) fn of(axis: &Axis) -> Option<Self> {
        let _ = axis;
        None
    }
}
