//! Stages that make their loop unstable even where the drive is ideal: a warning, and an error where the block starts ON.

use super::closed_loop::{points, stages, stated};
use crate::axis::Enable;
use crate::blocks::designed::Designed;
use crate::codes;
use crate::config::values::key;
use crate::number::{down_to, significant};
use crate::parameters::Name;
use crate::parameters::words::{Boolean, Words};
use crate::rules::effective::{Effective, as_written};
use stability::{Drive, Loop, MAX_MS, Points};

/// Judges the loop on the ideal drive, and on the one that the set states.
///
/// The ideal drive does exactly what was commanded one cycle before, which no machine can better: a loop that is unstable on it needs a drive
/// whose lag was measured. So such a set starts ON only where it states the drive that makes its loop stable (`drive.delay`,
/// `drive.time_constant`, `drive.response`), or consents (`accept_unstable`).
pub(super) fn advise(designed: &Designed, e: &mut Effective<'_>) {
    let axis = &designed.axis;
    if axis.control.master.is_some() {
        // A gantry slave's block never acts.
        return;
    }
    let stated = stated(&axis.drive);
    let drives: Vec<Drive<'_>> = std::iter::once(Drive::IDEAL).chain(stated).collect();
    let Some(points) = points(designed, &drives) else { return };
    let is_stable = |drive: Drive<'_>| Loop::new(&points, drive).is_stable();
    let is_error = axis.ipc.enable == Enable::On && axis.ipc.limit() > 0.0 && !is_accepted(e);
    match stated.map(|drive| (drive, is_stable(drive))) {
        None if is_stable(Drive::IDEAL) => {}
        None => say(designed, e, &points, (Drive::IDEAL, IDEAL), is_error),
        Some((drive, false)) => say(designed, e, &points, (drive, STATED), is_error),
        Some((_, true)) if is_stable(Drive::IDEAL) => {}
        Some((_, true)) => say(designed, e, &points, (Drive::IDEAL, IDEAL), false),
    }
}

const IDEAL: &str = "a drive that does exactly what was commanded one cycle before";
const STATED: &str = "the drive that the set states";

/// Whether the set consents to a loop that is unstable (`accept_unstable`).
fn is_accepted(e: &mut Effective<'_>) -> bool {
    e.validated_word::<Boolean>(key(Name::AcceptUnstable)) == Some(Boolean::True)
}

/// The stages, each with the weight up to which the loop stays calm; of several that only together are unstable, the part of all weights.
fn say(
    designed: &Designed,
    e: &mut Effective<'_>,
    points: &Points<'_>,
    (drive, what): (Drive<'_>, &str),
    is_error: bool,
) {
    let closed = Loop::new(points, drive);
    let [_, calm_part] = closed.largest_parts();
    for design in stages(designed) {
        let (i, weight) = (design.index, design.stage.weight());
        let [stable, calm] = [closed.largest_stable_weight(i), closed.largest_weight(i)];
        let asked = significant(weight, 4);
        let down = |value: f64| down_to(value, 3);
        let (found, instead) = match () {
            () if stable <= 0.0 => (
                format!("stage[{i}] with the weight {asked} is one of several with which {what} oscillates"),
                format!(
                    "a weight of {}, and {} % of the other weights",
                    down(weight * calm_part),
                    down(calm_part * 100.0)
                ),
            ),
            () => (
                format!(
                    "stage[{i}] with the weight {asked} makes {what} oscillate, from the weight {} on",
                    down(stable)
                ),
                format!("a weight of at most {}, up to which the loop stays calm (Ms <= {MAX_MS})", down(calm)),
            ),
        };
        let number = u32::try_from(i).expect("design: there are three stages");
        let place = (Name::WeightFactNum, [number, 0]);
        if is_error {
            let enable = key(Name::Enable);
            let dry_run = as_written(&e.place_of(enable), enable, &[Enable::DryRun.name()]);
            let allowed = "a block that starts ON, if its loop is stable with the drive that the set states (drive.delay, \
                           drive.time_constant, drive.response), or else with the ideal one";
            let instead = format!("{instead}; or {dry_run} until the drive is measured");
            e.refuse(codes::UNSTABLE, place, found, [Some(allowed.to_owned()), Some(instead)]);
        } else {
            e.warn(codes::WOULD_BE_UNSTABLE, place, found, Some(instead));
        }
    }
}
