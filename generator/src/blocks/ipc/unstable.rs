//! Stages that make their loop unstable even with an ideal drive: a warning, and an error if the block starts ON.

use super::calmer::{calmer, place, through, without_set_point};
use super::closed_loop::{Known, acts_through_position, on_a_rigid_axis, points, stages};
use super::usual;
use crate::axis::Enable;
use crate::blocks::designed::Designed;
use crate::codes;
use crate::config::values::{Key, key};
use crate::number::{down_to, significant};
use crate::parameters::Name;
use crate::parameters::words::{Boolean, Words};
use crate::rules::effective::{Effective, as_written};
use stability::{Loop, MAX_MS, STAGES};
use std::slice::from_ref;

/// Analyses the loop with the ideal drive, and with the stated one.
///
/// The ideal drive does exactly what was commanded one cycle before; no machine can be faster. A loop that is unstable with
/// it needs a drive whose lag was measured. Such a set starts ON only if it states the drive that makes its loop stable
/// (`drive.delay`, `drive.time_constant`, `drive.response`), or consents (`accept_unstable`). Returns whether it has reported
/// SET_POINT as the reason.
///
/// What lies between motor and load is not known: stages that look at `v_direct` are judged as on a rigid axis. A load that
/// can oscillate needs less.
pub(super) fn advise(designed: &Designed, gear: u32, e: &mut Effective<'_>) -> bool {
    let designed = &*on_a_rigid_axis(designed);
    let axis = &designed.axis;
    if axis.control.master.is_some() {
        // A gantry slave's block never acts.
        return false;
    }
    let drives = drives(designed);
    let usual = usual::drives(designed);
    let all = [drives.as_slice(), &usual].concat();
    let Some(points) = points(designed, &all, axis.drive.position_gain) else { return false };
    let is_error = axis.ipc.enable == Enable::On && axis.ipc.limit() > 0.0 && !is_accepted(e);
    // The stated drive comes first, the ideal one last.
    let mut judged = drives.iter().map(|drive| Loop::new(&points, drive.drive())).enumerate();
    let Some((n, closed)) = judged.find(|(_, closed)| !closed.is_stable()) else {
        return usual::advise(designed, &points, &usual, e);
    };
    let what = &name(&drives, n);
    // A stated drive with which the loop is stable replaces the consent.
    let is_error = is_error && n == 0;
    match axis.drive.position_gain.filter(|_| !closed.with([0.0; STAGES]).is_stable()) {
        Some(gain) => {
            without_stages(designed, e, (gain, gear), (&drives[n], what), is_error);
            false
        }
        None => say(designed, e, &closed, what, is_error),
    }
}

/// The drives with which a loop is judged: the stated one, and the ideal one last.
pub(super) fn drives(designed: &Designed) -> Vec<Known> {
    Known::stated(&designed.axis.drive).into_iter().chain([Known::IDEAL]).collect()
}

/// One of them in words.
pub(super) fn name(drives: &[Known], n: usize) -> String {
    if n + 1 == drives.len() { IDEAL.to_owned() } else { format!("the stated drive ({})", drives[n].words()) }
}

/// Reports a position loop that is unstable without any stage: the largest of the halved gains with which it is well damped.
fn without_stages(
    designed: &Designed,
    e: &mut Effective<'_>,
    (gain, gear): (f64, u32),
    (drive, what): (&Known, &str),
    is_error: bool,
) {
    let is_calm = |gain: f64| {
        let points = points(designed, from_ref(drive), Some(gain));
        let closed = points.as_ref().map(|points| Loop::new(points, drive.drive()).with([0.0; STAGES]).margins());
        closed.and_then(|margins| margins.ms).is_some_and(|[ms, _]| ms <= MAX_MS)
    };
    let mut halved = std::iter::successors(Some(gain / 2.0), |gain| Some(gain / 2.0)).take(HALVINGS);
    let calm = halved.find(|gain| is_calm(*gain)).map(|gain| (gain * 100.0).floor());
    let found = format!(
        "the position loop with Kv {}/s (P-AXIS-00099) makes {what} oscillate, without any stage",
        significant(gain, 4)
    );
    let instead = match calm.filter(|kv| *kv >= 1.0) {
        Some(kv) => {
            format!("getriebe[{gear}].kv {kv} or less, up to which the loop without stages stays calm (Ms <= {MAX_MS})")
        }
        None => format!("a smaller getriebe[{gear}].kv"),
    };
    report(e, (Name::Kv, [gear, 0]), found, instead, is_error);
}

/// Smaller gains are not tried: 2^-40 of the largest one is below a unit of P-AXIS-00099.
const HALVINGS: usize = 40;
const IDEAL: &str = "a drive that does exactly what was commanded one cycle before";

/// Whether the set consents to a loop that is unstable (`accept_unstable`).
fn is_accepted(e: &mut Effective<'_>) -> bool {
    e.validated_word::<Boolean>(key(Name::AcceptUnstable)) == Some(Boolean::True)
}

/// Reports the stages, each with the weight up to which the loop stays well damped. Stages that act through the position
/// controller are the reason if the loop is stable without them, else the others are; the rest is reported only if a
/// smaller weight of it helps. Returns whether the reason is SET_POINT.
fn say(designed: &Designed, e: &mut Effective<'_>, closed: &Loop<'_>, what: &str, is_error: bool) -> bool {
    let by_position = without_set_point(designed, closed).is_stable();
    for design in stages(designed) {
        let (i, weight) = (design.index, design.stage.weight());
        let [stable, _] = closed.largest_weights(i);
        if stable <= 0.0 && acts_through_position(&designed.axis.control, design.stage.mode) != by_position {
            continue;
        }
        let asked = significant(weight, 4);
        let found = match stable > 0.0 {
            true => {
                format!(
                    "stage[{i}] with the weight {asked} makes {what} oscillate, from the weight {} on",
                    down_to(stable, 3)
                )
            }
            false => format!("stage[{i}] with the weight {asked} is one of several with which {what} oscillates"),
        };
        let (place, position) = (place(i), through(designed, design));
        report(e, place, found + &position, calmer(designed, closed, design), is_error);
    }
    by_position
}

/// An error where the block starts ON, else a warning.
fn report(e: &mut Effective<'_>, place: Key, found: String, instead: String, is_error: bool) {
    if !is_error {
        return e.warn(codes::WOULD_BE_UNSTABLE, place, found, Some(instead));
    }
    let enable = key(Name::Enable);
    let dry_run = as_written(&e.place_of(enable), enable, &[Enable::DryRun.name()]);
    let allowed = "a block that starts ON, if its loop is stable with the stated drive (drive.delay, drive.time_constant, \
                   drive.response, P-AXIS-00191), or else with the ideal one";
    let instead = format!("{instead}; or {dry_run} until the drive is measured");
    e.refuse(codes::UNSTABLE, place, found, [Some(allowed.to_owned()), Some(instead)]);
}
