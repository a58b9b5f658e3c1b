//! The numbers of the excitation on a commissioning page: what it does to the machine, how long it takes. No text of steps.

use crate::axis::Axis;
use crate::number::{decimals, digits, significant};
use identification::excitation::FADE;

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
        let excitation = axis.excitation.as_ref()?.at(axis.cycle_time());
        let unit = axis.control.velocity_unit();
        let speed = excitation.least_speed();
        let length = if axis.control.is_rotary { "deg" } else { "mm" };
        let path = format!("{} {length}", decimals(excitation.path(speed) / 1e3, 1));
        let seconds = decimals(excitation.duration(), 1);
        let step = digits(excitation.step());
        let half_clock = excitation.sequence.half_clock(excitation.cycle_time);
        let fact = |what, value| Fact { what, value };
        Some(Self {
            sequence: format!("{}x{}", excitation.sequence.bits(), excitation.sequence.clock()),
            fade: digits(FADE),
            speed: digits(speed),
            facts: vec![
                fact("largest `v_excite`", format!("{} {unit}", digits(excitation.amplitude))),
                fact("steps of the velocity command", format!("{step} {unit}")),
                fact("steps of the force (or torque)", format!("{step} {unit} times Kp of the velocity controller")),
                fact("band of the excitation", format!("up to {} Hz", significant(half_clock, 3))),
                fact("duration", format!("{seconds} s")),
                fact("travel at the lowest velocity of step 3.2", path.clone()),
            ],
            seconds,
            path,
        })
    }
}
