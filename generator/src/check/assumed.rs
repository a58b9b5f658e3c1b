//! Values that scale or limit something and were not given: their defaults, and a warning if motion depends on them.

use crate::axis::{Axis, Enable, Feedforward, Motor, PositionControl};
use crate::parameters::Name;
use crate::{codes, config::values::key, diagnostics::Diagnostic, number::rounded, rules::effective::Effective};

/// What makes a missing value matter to an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Depends {
    /// whether the largest velocity limits something: an active stage or a changeover does
    is_limited: bool,
    /// whether P-AXIS-00092 scales something, and whether P-AXIS-00234/00233 does
    increments: bool,
    gear_ratio: bool,
}

impl Depends {
    /// Without a feed constant, R is the gear ratio alone. With one, the angle of a motor does not depend on its increments.
    pub(crate) fn new(is_limited: bool, feedforward: Option<&Feedforward>, of: Option<&PositionControl>) -> Self {
        let xerr = of.and_then(|of| of.resolution);
        let torque = feedforward.and_then(|of| of.torque_scale.as_ref()).filter(|of| of.motor == Motor::Rotary);
        let increments =
            xerr.is_some_and(|of| of.has_feed_const()) || torque.is_some_and(|of| !of.resolution.has_feed_const());
        Self { is_limited, increments, gear_ratio: xerr.is_some() || torque.is_some() }
    }

    /// Whether a missing value is reported.
    pub(crate) fn is_told(self, name: Name) -> bool {
        let of_velocity = matches!(name, Name::VResoNum | Name::VResoDenom | Name::VTimeBase);
        let of_position = matches!(name, Name::MultiGainZ | Name::MultiGainN | Name::ShiftTime);
        let of_increments = self.increments && name == Name::IncrPerRev;
        let of_gear_ratio = self.gear_ratio && matches!(name, Name::WegaufZ | Name::WegaufN);
        let of_limit = self.is_limited && name == Name::VbMax;
        of_velocity || of_position || of_increments || of_gear_ratio || of_limit
    }
}

pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let (ipc, control) = (&axis.ipc, &axis.control);
    let acts = ipc.is_active() && ipc.enable != Enable::Off && ipc.v_add_max_fact > 0;
    let resolution = control.position_control.as_ref().and_then(|of| of.resolution);
    let has_feed_const = resolution.is_some_and(|of| of.has_feed_const());
    let is_ratio_missing = [Name::WegaufZ, Name::WegaufN].into_iter().all(|name| e.given((name, [gear, 0])).is_none());
    let largest = format!("is the largest velocity of the spindle, {} rpm", rounded(ipc.v_max / 6000.0));
    let limit = format!("sets the limit |v_add| <= {} {}", ipc.limit(), control.velocity_unit());
    for (key, is_used, does) in [
        ((Name::VbMax, [gear, 0]), acts, limit.as_str()),
        ((Name::VbMax, [gear, 0]), !acts && control.spindle.is_some(), largest.as_str()),
        ((Name::IncrPerRev, [gear, 0]), has_feed_const, "scales the control deviation XERR"),
        (
            (Name::WegaufZ, [gear, 0]),
            resolution.is_some() && !has_feed_const && is_ratio_missing,
            "and that of wegaufn (P-AXIS-00233) scale the control deviation XERR, without a feed constant (P-AXIS-00362/00363)",
        ),
        (key(Name::ShiftTime), resolution.is_some(), "shifts the position after the feedforward"),
    ] {
        let parameter = key.0.parameter();
        if is_used && e.is_used(key) && e.given(key).is_none() {
            let default = parameter.default_at(key.1).unwrap_or_default();
            let found =
                format!("{} is not given: its default {default} {does}", parameter.title(parameter.path, key.1));
            let place = e.place_near(key, |name| {
                let of_changeover = Name::VVelocityControlOn..=Name::VelocityPositionControlOff;
                matches!(name, Name::Enable | Name::DriveType) || of_changeover.contains(&name)
            });
            let diagnostic = Diagnostic::warning(codes::ASSUMED, place, found);
            e.report.push(diagnostic.instead(format!("{} with the value of the machine", parameter.short())));
        }
    }
}
