//! Values that scale or limit something and were not given: their defaults, and a warning if motion depends on them.

use crate::axis::{Axis, Enable};
use crate::parameters::Name;
use crate::{codes, config::values::key, diagnostics::Diagnostic, number::rounded, rules::effective::Effective};

/// Whether a missing value is reported. Without an active stage or a changeover the largest velocity limits nothing.
pub(crate) fn is_told(name: Name, is_limited: bool) -> bool {
    let of_velocity = matches!(name, Name::VResoNum | Name::VResoDenom | Name::VTimeBase);
    let of_position = matches!(name, Name::MultiGainZ | Name::MultiGainN | Name::IncrPerRev | Name::ShiftTime);
    of_velocity || of_position || name == Name::VbMax && is_limited
}

pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let (ipc, control) = (&axis.ipc, &axis.control);
    let acts = ipc.is_active() && ipc.enable != Enable::Off && ipc.v_add_max_fact > 0;
    let is_profidrive = control.position_control.as_ref().is_some_and(|of| of.resolution.is_some());
    let largest = format!("is the largest velocity of the spindle, {} rpm", rounded(ipc.v_max / 6000.0));
    let limit = format!("sets the limit |v_add| <= {} {}", ipc.limit(), control.velocity_unit());
    for (key, is_used, does) in [
        ((Name::VbMax, [gear, 0]), acts, limit.as_str()),
        ((Name::VbMax, [gear, 0]), !acts && control.spindle.is_some(), largest.as_str()),
        ((Name::IncrPerRev, [gear, 0]), is_profidrive, "scales the control deviation XERR"),
        (key(Name::ShiftTime), is_profidrive, "shifts the position after the feedforward"),
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
