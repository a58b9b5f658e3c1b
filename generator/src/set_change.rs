//! Whether a parameter set can carry a change of an axis: the common decision of `params-of` and the semantic diff. Nothing
//! is printed here.

use crate::axis::{Filter, Stage};
use crate::blocks::ipc::filter;
use crate::blocks::{self, Design, Designed, Effect, Effects, IPC, SET_DESIGN, differences};
use crate::design::rounding::rounded;
use crate::number::pair;
use crate::parameters::words::{StageMode, Words};
use compiler::leaves;
use portable::{Literal, Real, RealKind, with_numbers};
use reference::ipc::Coeffs as IpcCoeffs;
use reference::set_design;
use reference::sets::{self, Coeffs};
use reference::tunable_ipc::TunableIpc;

/// The effect of a parameter set of the new version on the block on the machine, which was generated from the old one.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// the reason why the block does not take it over; `None` if it does
    pub refused: Option<Refusal>,
    /// changes of the new version that a set does not contain, in words: the block continues without them
    pub left: Vec<String>,
}

/// The reason why a block does not take over a parameter set.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// the old version takes no sets
    NoSetsBefore,
    /// the new version takes no sets
    NoSetsAfter,
    /// the differences of the structure, in words; the block reports error id 6
    Structure(Vec<String>),
    /// the limit of the block and the larger one of the set [um/s or 0.001 deg/s]; the block reports error id 7
    Limit([f64; 2]),
    /// a number is out of range for the block; the error id that it reports
    Numbers(u32),
}

impl Judgement {
    /// The reasons for new code, in words; empty if none is needed.
    pub fn reasons(&self) -> Vec<String> {
        let mut reasons = match &self.refused {
            None => Vec::new(),
            Some(Refusal::NoSetsBefore | Refusal::NoSetsAfter) => {
                vec!["one of the versions takes no parameter sets".to_owned()]
            }
            Some(Refusal::Structure(lines)) => lines.clone(),
            Some(Refusal::Limit([old, new])) => vec![format!("limit {}", pair(*old, *new, 7))],
            Some(Refusal::Numbers(id)) => vec![format!("numbers that the block refuses with error_id {id}")],
        };
        reasons.extend(self.left.iter().cloned());
        reasons
    }
}

/// Judges the change from one version of an axis to another.
pub fn judge(old: &Designed, new: &Designed) -> Judgement {
    match old.axis.real {
        RealKind::F64 => judge_in::<f64>(old, new),
        RealKind::F32 => judge_in::<f32>(old, new),
    }
}

/// Judges the change in the real type of the block on the machine.
fn judge_in<R: Real>(old: &Designed, new: &Designed) -> Judgement {
    let refused = match (old.axis.ipc.takes_sets(), new.axis.ipc.takes_sets()) {
        (false, _) => Some(Refusal::NoSetsBefore),
        (true, false) => Some(Refusal::NoSetsAfter),
        (true, true) => refusal::<R>(old, new),
    };
    let mut left = differences(&apart_from_set(old), &apart_from_set(new));
    left.extend(other_blocks(old, new));
    // No change may stay unreported: the old block with the new numbers must equal the new block, apart from the reported
    // changes.
    if left.is_empty() && refused.is_none() && !is_new::<R>(old, new) {
        left.push("coefficients that are not part of a parameter set".to_owned());
    }
    Judgement { refused, left }
}

/// The reason why the block on the machine refuses the set; the structure is checked first, as in the block.
fn refusal<R: Real>(old: &Designed, new: &Designed) -> Option<Refusal> {
    let mut lines = differences(&structure(old), &structure(new));
    if lines.is_empty() && old.sets[0] != new.sets[0] {
        lines.push("structure".to_owned());
    }
    if !lines.is_empty() {
        return Some(Refusal::Structure(lines));
    }
    let [block, set] = [old, new].map(coeffs::<R>);
    if set.ipc.limit > block.ipc.limit {
        return Some(Refusal::Limit([old, new].map(|of| of.ipc.limit)));
    }
    // The check that the block itself performs.
    let error = sets::refusal(&block, &sets::params(&set));
    (error != reference::signal::error_none()).then_some(Refusal::Numbers(error))
}

/// Whether the old block with the new numbers has the coefficients of the new block.
fn is_new<R: Real>(old: &Designed, new: &Designed) -> bool {
    let [block, set] = [old, new].map(coeffs::<R>);
    let then: IpcCoeffs<R> = with_numbers(&block.ipc, &sets::numbers_of(&set.ipc));
    leaves(&then) == leaves(&set.ipc)
}

fn coeffs<R: Real>(of: &Designed) -> Coeffs<R> {
    rounded(&TunableIpc::design(of), R::KIND)
}

/// The parts of the structure id, in the words of the semantic diff.
fn structure(of: &Designed) -> Effects {
    let (axis, ipc) = (&of.axis, &of.ipc);
    let watch = match ipc.watch.active {
        true => format!("in blocks of {} cycles, alarm {}", ipc.watch.block_cycles, ipc.watch.alarm),
        false => "none".to_owned(),
    };
    let mut values = vec![
        ("axis".to_owned(), Effect::Words(axis.name.clone())),
        ("cycle time".to_owned(), Effect::Number(f64::from(axis.cycle_time_ns) / 1e3, " us")),
        ("real type".to_owned(), Effect::Words(axis.real_name().to_owned())),
        ("calls".to_owned(), Effect::Words(axis.calls().to_owned())),
        ("fade".to_owned(), Effect::Number(f64::from(ipc.fade_cycles), " cycles")),
        ("rides through".to_owned(), Effect::Number(f64::from(ipc.ride_through.cycles), " bad samples in a row")),
        ("watch".to_owned(), Effect::Words(watch)),
        ("gantry slave".to_owned(), Effect::Words(if ipc.slave { "yes" } else { "no" }.to_owned())),
    ];
    values.extend(axis.ipc.stage.iter().enumerate().map(|(index, stage)| {
        let text = stage.as_ref().map_or_else(|| StageMode::NotActive.name().to_owned(), parts);
        (format!("stage[{index}]"), Effect::Words(text))
    }));
    values
}

/// The source of a stage and its sections, without their numbers.
fn parts(stage: &Stage) -> String {
    let filter = |of: &Filter| match filter::of(of) {
        Some(kind) => format!(", {}", kind.structure()),
        None => format!(", {}", of.kind().name()),
    };
    stage.mode.text() + &stage.filter.iter().map(filter).collect::<String>()
}

/// The properties of a block besides its structure and the numbers of a set.
fn apart_from_set(of: &Designed) -> Effects {
    let ipc = &of.axis.ipc;
    vec![
        ("starts".to_owned(), Effect::Words(ipc.enable.name().to_owned())),
        ("v_max".to_owned(), Effect::Number(ipc.v_max, "")),
        ("axis type".to_owned(), Effect::Words(of.axis.control.axis_type().name().to_owned())),
    ]
}

/// The other blocks of the axis that differ, each in words.
fn other_blocks(old: &Designed, new: &Designed) -> Vec<String> {
    // A set has the same numbers whatever the inputs of its design start with.
    let design =
        |of: &Designed| leaves(&set_design::Coeffs { generated: <_>::default(), set: <_>::default(), ..of.set_design });
    let others = |of: &Designed| -> Vec<(&'static str, Vec<Literal>)> {
        let kinds = blocks::of_axis(&of.axis).filter(|kind| kind.name() != IPC);
        let numbers = |name: &str| (name == SET_DESIGN).then(|| design(of));
        kinds.map(|kind| (kind.name(), numbers(kind.name()).unwrap_or_else(|| kind.coefficients(of)))).collect()
    };
    // In the blocks of a whole axis a set carries the numbers of improved position control, too.
    let with_old_set = Designed { ipc: old.ipc, sets: old.sets, ..new.clone() };
    let (before, after) = (others(old), others(&with_old_set));
    let changed = before.iter().filter(|of| !after.contains(of)).map(|(name, _)| *name);
    let added = after.iter().filter(|(name, _)| before.iter().all(|(other, _)| other != name)).map(|(name, _)| *name);
    changed.chain(added).map(|name| format!("the block {name} differs")).collect()
}
