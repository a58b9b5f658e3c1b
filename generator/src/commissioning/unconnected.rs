//! What a block shows before its outputs are connected, if it contains position control: names and words. No numbers.

use crate::axis::{Axis, Location};
use portable::RealKind;

/// The command of the block, and what it is compared with.
pub(super) struct Unconnected {
    /// what the drive would get
    pub(super) command: &'static str,
    /// what it gets from another controller
    pub(super) received: &'static str,
    /// what holds at standstill, so that nothing steps
    pub(super) at_rest: &'static str,
    /// whether the block has feedforward
    pub(super) leads: bool,
}

impl Unconnected {
    /// Of a block that contains position control; without a location it is in the CNC.
    pub(super) fn new(axis: &Axis) -> Self {
        let location = axis.control.location.unwrap_or(Location::Cnc);
        let [command, received, at_rest] = match location {
            Location::Cnc => {
                let takes_error = axis.real == RealKind::F32 && axis.control.spindle.is_none();
                let at_rest = if takes_error { "`following_error` 0" } else { "`x_command` equal to `x_actual`" };
                ["`manipulated_variable`", "velocity command", at_rest]
            }
            Location::Profidrive => ["`xerr`", "control deviation", "`xerr` 0"],
            Location::Drive => {
                let at_rest = "`x_drive` equal to the position command that the drive receives";
                ["the change of `x_drive`", "change of the position command", at_rest]
            }
        };
        Self { command, received, at_rest, leads: axis.control.feedforward.is_some() }
    }
}
