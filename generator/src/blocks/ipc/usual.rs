//! Stages that make their loop unstable with both usual drives, where no drive is stated: a warning.

use super::calmer::{calmer, place, through, without_set_point};
use super::closed_loop::{Known, acts_through_position, stages};
use super::stage::StageDesign;
use crate::blocks::designed::Designed;
use crate::codes;
use crate::number::{down_to, significant};
use crate::rules::effective::Effective;
use stability::{Loop, Points, STAGES};

/// The usual drives, if none is stated.
pub(super) fn drives(designed: &Designed) -> Vec<Known> {
    let model = &designed.axis.drive;
    if model.is_given() { Vec::new() } else { Known::of(model) }
}

/// Warns of a loop that is stable with the ideal drive and with none of these. One that is unstable without any stage has
/// another warning, about its Kv. Returns whether SET_POINT is the reason.
pub(super) fn advise(designed: &Designed, points: &Points<'_>, usual: &[Known], e: &mut Effective<'_>) -> bool {
    let loops = usual.iter().map(|drive| (drive, Loop::new(points, drive.drive())));
    let unstable = loops.map(|(drive, closed)| (!closed.is_stable()).then_some((drive, closed)));
    let Some(loops) = unstable.collect::<Option<Vec<_>>>() else { return false };
    if loops.iter().any(|(_, closed)| !closed.with([0.0; STAGES]).is_stable()) {
        return false;
    }
    let of_stages: Vec<_> = stages(designed).map(|design| (design, weights(&loops, design))).collect();
    let one_helps = of_stages.iter().any(|(_, of)| helps(of));
    let by_position = loops.iter().any(|(_, closed)| without_set_point(designed, closed).is_stable());
    for (design, of) in &of_stages {
        let is_inside = acts_through_position(&designed.axis.control, design.stage.mode);
        if helps(of) || !one_helps && is_inside == by_position {
            say(designed, design, of, e);
        }
    }
    by_position
}

/// The largest stable and the largest calm weight of a stage with a drive, that drive, and its loop.
type Weights<'l, 'p> = ([f64; 2], &'l Known, &'l Loop<'p>);

/// The largest weights of a stage with each drive. The drive that leaves less comes first: its remedy holds for both.
fn weights<'l, 'p>(loops: &'l [(&'l Known, Loop<'p>)], design: &StageDesign) -> Vec<Weights<'l, 'p>> {
    let of = loops.iter().map(|(drive, closed)| (closed.largest_weights(design.index), *drive, closed));
    let mut of: Vec<_> = of.collect();
    of.sort_by(|([a, calm_a], ..), ([b, calm_b], ..)| calm_a.total_cmp(calm_b).then(a.total_cmp(b)));
    of
}

/// Whether a smaller weight of the stage makes the loop stable with each drive.
fn helps(of: &[Weights<'_, '_>]) -> bool {
    of.iter().all(|([stable, _], ..)| *stable > 0.0)
}

/// Warns of a stage.
fn say(designed: &Designed, design: &StageDesign, of: &[Weights<'_, '_>], e: &mut Effective<'_>) {
    let Some((_, _, worst)) = of.first() else { return };
    let (i, weight) = (design.index, significant(design.stage.weight(), 4));
    let stage = format!("stage[{i}] with the weight {weight}");
    let with = |([stable, _], drive, _): &Weights<'_, '_>| {
        format!("{}: from the weight {} on", drive.words(), down_to(*stable, 3))
    };
    let found = match helps(of) {
        true => {
            let with = of.iter().map(with).collect::<Vec<_>>().join("; ");
            format!("{stage} makes both usual drives oscillate ({with})")
        }
        false => format!("{stage} is one of several with which both usual drives oscillate"),
    };
    let found = format!("{found}, and no drive is stated{}", through(designed, design));
    let instead = calmer(designed, worst, design) + "; or the measured drive (drive.delay, drive.response)";
    e.warn(codes::UNSTABLE_USUALLY, place(i), found, Some(instead));
}
