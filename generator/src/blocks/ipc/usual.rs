//! Stages that make their loop unstable with both usual drives, where no drive is stated: a warning.

use super::calmer::{calmer, place, through, without_set_point};
use super::closed_loop::{Known, acts_through_position, stages};
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
    let mut loops = Vec::with_capacity(usual.len());
    for drive in usual {
        let closed = Loop::new(points, drive.drive());
        if closed.is_stable() {
            return false;
        }
        loops.push((drive, closed));
    }
    if loops.iter().any(|(_, closed)| !closed.with([0.0; STAGES]).is_stable()) {
        return false;
    }
    let mut of_stages = Vec::new();
    for design in stages(designed) {
        let mut of: Vec<_> =
            loops.iter().map(|(drive, closed)| (closed.largest_weights(design.index), *drive, closed)).collect();
        // The remedy is that of the drive which leaves less: it holds for both.
        of.sort_by(|([a, calm_a], ..), ([b, calm_b], ..)| calm_a.total_cmp(calm_b).then(a.total_cmp(b)));
        of_stages.push((design, of));
    }
    let helps = |of: &[([f64; 2], &Known, &Loop<'_>)]| of.iter().all(|([stable, _], ..)| *stable > 0.0);
    let one_helps = of_stages.iter().any(|(_, of)| helps(of));
    let by_position = loops.iter().any(|(_, closed)| without_set_point(designed, closed).is_stable());
    for (design, of) in &of_stages {
        let (i, is_inside) = (design.index, acts_through_position(&designed.axis.control, design.stage.mode));
        if !helps(of) && (one_helps || is_inside != by_position) {
            continue;
        }
        let weight = significant(design.stage.weight(), 4);
        let with = |([stable, _], drive, _): &([f64; 2], &Known, &Loop<'_>)| {
            format!("{}: from the weight {} on", drive.words(), down_to(*stable, 3))
        };
        let found = match one_helps {
            true => {
                let with = of.iter().map(with).collect::<Vec<_>>().join("; ");
                format!("stage[{i}] with the weight {weight} makes both usual drives oscillate ({with})")
            }
            false => {
                format!("stage[{i}] with the weight {weight} is one of several with which both usual drives oscillate")
            }
        };
        let found = format!("{found}, and no drive is stated{}", through(designed, design));
        let Some((_, _, worst)) = of.first() else { continue };
        let instead = calmer(designed, worst, design) + "; or the measured drive (drive.delay, drive.response)";
        e.warn(codes::UNSTABLE_USUALLY, place(i), found, Some(instead));
    }
    by_position
}
