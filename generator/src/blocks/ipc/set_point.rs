//! Warnings about weights of SET_POINT in a stable loop: they leave the position loop little reserve, or amplify the vibration.

use super::closed_loop::{acts_through_position, points};
use super::stage::StageDesign;
use super::unstable::{calmer, drives, name, place, through};
use crate::axis::Mode;
use crate::blocks::designed::Designed;
use crate::codes;
use crate::number::{rounded, significant};
use crate::rules::effective::Effective;
use stability::{Loop, MAX_MS};

/// Warns of each stage once; of one in a loop that oscillates, which has been reported, not again.
pub(super) fn advise(designed: &Designed, oscillates: bool, e: &mut Effective<'_>) {
    let control = &designed.axis.control;
    let drives = drives(designed);
    let points = points(designed, &drives, designed.axis.drive.position_gain).filter(|_| control.master.is_none());
    let closed = points.as_ref().map(|points| Loop::new(points, drives[0].drive()));
    let restless = closed.filter(|closed| !oscillates && is_restless(designed, closed));
    for design in designed.stage.iter().flatten() {
        let is_inside = acts_through_position(control, design.stage.mode);
        match &restless {
            Some(closed) if is_inside => {
                let found = format!(
                    "stage[{}] is SET_POINT with the weight {}, with which {} has little reserve (Ms > {MAX_MS}){}",
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

/// Whether it is SET_POINT that takes the reserve of a loop: without it there is some.
fn is_restless(designed: &Designed, closed: &Loop<'_>) -> bool {
    let is_calm = |closed: &Loop<'_>| closed.margins().ms.is_some_and(|[ms, _]| ms <= MAX_MS);
    let rest = designed.stage.each_ref().map(|design| match design.as_ref().map(|design| &design.stage) {
        Some(stage) if !matches!(stage.mode, Mode::SetPoint { .. }) => stage.weight(),
        Some(_) | None => 0.0,
    });
    !is_calm(closed) && is_calm(&closed.with(rest))
}

/// SET_POINT multiplies the command by 1 - w H: above twice its best weight it amplifies the vibration.
fn amplifies(e: &mut Effective<'_>, design: &StageDesign) {
    let Mode::SetPoint { osc_damping } = design.stage.mode else { return };
    let four_d_squared = 4.0 * osc_damping * osc_damping;
    let best = four_d_squared / (four_d_squared + 1.0);
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
