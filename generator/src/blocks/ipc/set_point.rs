//! Warnings about weights of SET_POINT in a stable loop: they leave the position loop little reserve, or amplify the vibration.

use super::calmer::{best, calmer, place, through, without_set_point};
use super::closed_loop::{acts_through_position, points};
use super::stage::StageDesign;
use super::unstable::{drives, name};
use crate::blocks::designed::Designed;
use crate::codes;
use crate::number::{rounded, significant};
use crate::rules::effective::Effective;
use portable::Extreme;
use stability::{Loop, MAX_MS};

/// With a smaller ratio of Ms with SET_POINT to that without it, the other stages are the reason.
const CLEARLY: f64 = 1.1;

/// Warns of each stage once; of one in a loop that oscillates, which has been reported, not again.
pub(super) fn advise(designed: &Designed, oscillates: bool, e: &mut Effective<'_>) {
    if designed.stage.iter().flatten().all(|design| best(design).is_none()) {
        return; // the margins of the loop take long
    }
    let control = &designed.axis.control;
    let drives = drives(designed);
    let points = points(designed, &drives, designed.axis.drive.position_gain).filter(|_| control.master.is_none());
    let closed = points.as_ref().filter(|_| !oscillates).map(|points| Loop::new(points, drives[0].drive()));
    let restless = closed.and_then(|closed| Some((restless(designed, &closed)?, closed)));
    for design in designed.stage.iter().flatten() {
        let is_inside = acts_through_position(control, design.stage.mode);
        match &restless {
            // The best weight against the vibration is calm, too: the weight is above twice that.
            Some((_, closed))
                if best(design).is_some_and(|best| {
                    best <= closed.largest_weights(design.index)[1].smaller(design.stage.weight() / 2.0)
                }) =>
            {
                amplifies(e, design);
            }
            Some((ms, closed)) if is_inside => {
                let found = format!(
                    "stage[{}] is SET_POINT with the weight {}, with which {} has little reserve (Ms {ms}){}",
                    design.index,
                    significant(design.stage.weight(), 4),
                    name(&drives, 0),
                    through(designed, design)
                );
                e.warn(codes::SET_POINT, place(design.index), found, calmer(designed, closed, design));
            }
            None if is_inside && oscillates => {}
            Some(_) | None => amplifies(e, design),
        }
    }
}

/// Ms of a loop from which SET_POINT takes the reserve: without it there is clearly more.
fn restless(designed: &Designed, closed: &Loop<'_>) -> Option<String> {
    let ms = |closed: &Loop<'_>| closed.margins().ms.map_or(f64::INFINITY, |[ms, _]| ms);
    let (with, without) = (ms(closed), ms(&without_set_point(designed, closed)));
    let text = || if with.is_finite() { significant(with, 3) } else { "without a bound".to_owned() };
    (with > MAX_MS && with > CLEARLY * without).then(text)
}

/// SET_POINT multiplies the command by 1 - w H: above twice its best weight it amplifies the vibration.
fn amplifies(e: &mut Effective<'_>, design: &StageDesign) {
    let Some(best) = best(design) else { return };
    if design.stage.weight() > 2.0 * best {
        let found = format!(
            "stage[{}] is SET_POINT with the weight {}: above {} it amplifies what it is to damp",
            design.index,
            rounded(design.stage.weight()),
            rounded(2.0 * best)
        );
        let instead = Some(format!("about {}, the best weight at this damping", rounded(best)));
        e.warn(codes::SET_POINT, place(design.index), found, instead);
    }
}
