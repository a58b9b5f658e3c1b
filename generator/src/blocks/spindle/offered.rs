//! Requirements on a drive that changes its operation mode: cyclic data and settings; and which of them are missing.

use crate::axis::Bus;
use crate::config::values::key;
use crate::parameters::Name;
use crate::parameters::words::{DriveObject, DriveSetting, Words};
use crate::{codes, diagnostics::Diagnostic, rules::effective::Effective};

/// Words of which one is needed, and their meaning.
pub(super) type Need<T> = (&'static [T], &'static str);

/// The required cyclic data; for a drive with velocity control alone, the velocities.
pub(super) fn objects(bus: Bus, is_alone: bool) -> &'static [Need<DriveObject>] {
    use DriveObject::*;
    match bus {
        Bus::Sercos if is_alone => {
            &[(&[SercosVelocityCommand], "the velocity command"), (&[SercosVelocity], "the actual velocity")]
        }
        Bus::CanOpen if is_alone => {
            &[(&[TargetVelocity], "the velocity command"), (&[Velocity], "the actual velocity")]
        }
        Bus::Sercos => &[
            (&[SercosVelocityCommand], "the velocity command"),
            (&[SercosVelocity], "the actual velocity"),
            (&[SercosPositionCommand], "the position command"),
            (&[SercosPosition1, SercosPosition2], "the actual position"),
        ],
        Bus::CanOpen => &[
            (&[Mode], "the operation mode"),
            (&[ModeDisplay], "the display of the operation mode"),
            (&[TargetPosition], "the position command"),
            (&[Position], "the actual position"),
            (&[TargetVelocity], "the velocity command"),
            (&[Velocity], "the actual velocity"),
        ],
    }
}

/// The required settings; the operation mode of velocity control is one of them.
pub(super) fn settings(bus: Bus, velocity_mode: i32, is_alone: bool) -> Vec<Need<DriveSetting>> {
    if bus == Bus::CanOpen {
        return Vec::new();
    }
    let auxiliary: Need<DriveSetting> = match velocity_mode {
        2 => (&[DriveSetting::Auxiliary2Velocity], "velocity control in the auxiliary mode 2"),
        3 => (&[DriveSetting::Auxiliary3Velocity], "velocity control in the auxiliary mode 3"),
        _ => (&[DriveSetting::Auxiliary1Velocity], "velocity control in the auxiliary mode 1"),
    };
    let rotary: Need<DriveSetting> = (&[DriveSetting::RotaryVelocity], "rotary scaling of velocities");
    if is_alone {
        // The main mode is the drive's only mode.
        return if velocity_mode == 0 { vec![rotary] } else { vec![auxiliary, rotary] };
    }
    vec![
        (&[DriveSetting::MainPosition], "position control in the main mode"),
        auxiliary,
        (&[DriveSetting::RotaryPosition], "rotary scaling of positions"),
        rotary,
        (&[DriveSetting::RotaryAcceleration], "rotary scaling of accelerations"),
    ]
}

/// Checks that the given words are complete, and reports all that are missing.
pub(super) fn check(e: &mut Effective<'_>, bus: Bus, velocity_mode: i32, is_alone: bool) {
    missing(e, Name::ProcessDataObjects, objects(bus, is_alone));
    missing(e, Name::DriveSettings, &settings(bus, velocity_mode, is_alone));
}

fn missing<T: Words>(e: &mut Effective<'_>, name: Name, needs: &[Need<T>]) {
    let at = key(name);
    if e.given(at).is_none() || needs.is_empty() {
        return;
    }
    let Some(offered) = e.validated_words::<T>(at) else { return };
    let allowed = needs.iter().map(|(words, _)| one_of(words)).collect::<Vec<_>>().join(", ");
    for (words, what) in needs.iter().filter(|(words, _)| !words.iter().any(|word| offered.contains(word))) {
        let found = format!("{} has no {}, {what}: the changeover needs it", e.title(at), one_of(words));
        let said = Diagnostic::error(codes::NOT_OFFERED, e.place_of(at), found).allowed(allowed.clone());
        let path = name.parameter().path;
        e.report.push(said.instead(format!("\"{}\" in {path}, if the drive has it", words[0].name())));
    }
}

/// `S-0-0051 or S-0-0053`.
pub(super) fn one_of<T: Words>(words: &[T]) -> String {
    words.iter().map(|word| word.name()).collect::<Vec<_>>().join(" or ")
}
