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
    /// what a difference would do
    pub(super) step: &'static str,
    /// whether the block has feedforward
    pub(super) leads: bool,
    /// whether the block has the gain of the position controller
    pub(super) has_kv: bool,
}

impl Unconnected {
    /// Of a block that contains position control; without a location it is in the CNC.
    pub(super) fn new(axis: &Axis) -> Self {
        let location = axis.control.location.unwrap_or(Location::Cnc);
        let [command, received, at_rest, step] = match location {
            Location::Cnc => {
                let takes_error = axis.real == RealKind::F32 && axis.control.spindle.is_none();
                let at_rest = if takes_error { "`following_error` 0" } else { "`x_command` equal to `x_actual`" };
                ["`manipulated_variable`", "velocity command", at_rest, "a deviation acts with Kv in the first cycle"]
            }
            Location::Profidrive => {
                ["`xerr`", "control deviation", "`xerr` 0", "a control deviation acts in the first cycle"]
            }
            Location::Drive => {
                let at_rest = "`x_drive` equal to the position command that the drive receives";
                let step = "a difference is a step of the position command";
                ["the change of `x_drive`", "change of the position command", at_rest, step]
            }
        };
        let leads = axis.control.feedforward.is_some();
        Self { command, received, at_rest, step, leads, has_kv: location == Location::Cnc || leads }
    }
}
