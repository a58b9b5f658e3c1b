//! Proposes stages from recordings: recommended, strong, cautious, with the remaining part of each vibration; first ones if
//! the response of the drive is unknown. The search is in the crate `identification`. No file, nothing is written into a
//! set.

mod chosen;
mod proposal;
pub mod signals;
mod stage;
pub mod text;

pub use chosen::Chosen;
pub use identification::proposals::Kind;
pub use identification::proposals::Prediction;
pub use proposal::Proposal;

use crate::measure::{Channel, Measured, Quantity, Record, Verdict, find_error_unit, is_same_interval};
use generator::analysis::looks_at_motor;
use generator::axis::{Axis, Stage};
use generator::blocks::Designed;
use generator::codes;
use identification::offset;
use identification::response::Lines;
use identification::segments;
use portable::{Extreme, peak};

/// A motor that is slower than this part of its peak is at rest.
const AT_REST: f64 = 0.05;
/// An offset of that part of a cycle is one.
const LATE: f64 = 0.25;

/// The response of the drive to be used.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Prefer {
    /// that of the excited recording, if there is one
    Excited,
    /// that of the set, or of the option that overrides it
    Set,
}

/// Which stages the report is about.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Stages {
    /// those that are proposed
    Proposed,
    /// those that the axis has
    Given,
}

/// What is proposed for an axis.
#[derive(Clone, Debug, Default)]
pub struct Tuning {
    /// [s]
    pub cycle_time: f64,
    /// degrees instead of millimetres
    pub is_rotary: bool,
    /// Kv [1/s] of a position loop in the CNC, and in the drive; `None` if the set does not state it
    pub gains: [Option<f64>; 2],
    /// the vibrations, in the order of the stages
    pub chosen: Vec<Chosen>,
    pub proposals: Vec<Proposal>,
    pub verdicts: Vec<Verdict>,
    /// the response of the drive; `None` if it is not known
    pub lines: Option<Lines>,
}

/// Proposes stages for an axis from its moves with the stages off, and from an excited recording of the same machine; or says
/// what the stages that the axis has would do.
#[must_use]
pub fn tune(
    designed: &Designed,
    moves: &Measured,
    excited: Option<&Measured>,
    prefer: Prefer,
    stages: Stages,
) -> Tuning {
    let axis = &designed.axis;
    let mut tuning = Tuning {
        cycle_time: axis.cycle_time(),
        is_rotary: axis.control.is_rotary,
        gains: axis.control.placed(axis.drive.position_gain),
        ..Tuning::default()
    };
    let all = [Some(moves), excited];
    if all.iter().flatten().any(|measured| measured.refuses()) {
        return tuning;
    }
    let records: Vec<&Record> = all.iter().flatten().filter_map(|measured| measured.record.as_ref()).collect();
    let is_usable = is_usable(axis, moves, &records, &mut tuning);
    let Some(record) = moves.record.as_ref().filter(|_| is_usable) else { return tuning };
    tuning.verdicts.extend(records.iter().find_map(|record| of_other_kind(record, tuning.is_rotary)));
    let before = tuning.verdicts.len();
    tuning.chosen = chosen::choose(moves, &mut tuning.verdicts);
    let lines = response(axis, excited, prefer);
    if tuning.chosen.is_empty() {
        let left_out = if tuning.verdicts.len() == before { "" } else { " that a stage can damp" };
        let found = format!("no vibration{left_out} at constant speed or after a ramp");
        let instead = "record a move that shows it, with x_command, v_motor and a sensor at the load";
        tuning.verdicts.push(Verdict::refusal(codes::NO_PROPOSAL, found, instead));
        return tuning;
    }
    find_error_unit(record, axis.drive.position_gain, &mut tuning.verdicts);
    let of = proposal::Task { axis, record, ramps: segments::ramps(&moves.segments).collect(), chosen: &tuning.chosen };
    if let Some(proposals) = proposals(&of, lines.as_ref(), stages, &mut tuning.verdicts) {
        (tuning.proposals, tuning.lines) = (proposals, lines);
    }
    tuning
}

fn response(axis: &Axis, excited: Option<&Measured>, prefer: Prefer) -> Option<Lines> {
    let of_set = axis.drive.response.as_ref().map(|measured| Lines::of(&measured.response));
    let of_excited = excited.and_then(|measured| Some(measured.excited.as_ref()?.lines.clone()));
    match prefer {
        Prefer::Excited => of_excited.or(of_set),
        Prefer::Set => of_set.or(of_excited),
    }
}

/// The proposals, or the prediction for the stages of the axis; `None` if it has no stages to be predicted.
fn proposals(
    of: &proposal::Task<'_>,
    lines: Option<&Lines>,
    stages: Stages,
    verdicts: &mut Vec<Verdict>,
) -> Option<Vec<Proposal>> {
    let given = match stages {
        Stages::Proposed => None,
        Stages::Given => Some(of.given(verdicts)?),
    };
    Some(match (lines, given) {
        (Some(lines), given) => of.proposals(lines, given.as_deref(), verdicts),
        (None, Some(_)) => {
            let instead = "measure it: --excited FILE, --response FILE, or drive.response of the set";
            let found = "the response of the drive is not known";
            verdicts.push(Verdict::refusal(codes::NOT_PREDICTED, found, instead));
            Vec::new()
        }
        (None, None) => of.first(verdicts),
    })
}

/// The first velocity or position whose stated unit is that of the other kind of axis: probably another axis was recorded.
fn of_other_kind(record: &Record, is_rotary: bool) -> Option<Verdict> {
    let is_way = |channel: &&Channel| channel.is_stated && channel.quantity != Quantity::Acceleration;
    let units = record.channels().iter().filter(is_way).filter_map(|channel| Some((channel.signal, channel.unit?)));
    let (signal, unit) = units.into_iter().find(|(_, unit)| unit.is_rotary() != is_rotary)?;
    let kind = if is_rotary { "is a rotary axis or a spindle" } else { "moves along a line" };
    let found = format!("{signal} is in {}, and the axis of the set {kind}", unit.name);
    Some(Verdict::note(codes::UNITS_DIFFER, found, "record this axis, or select the recorded one with --axis"))
}

/// Whether what stages would do to the moves can be known.
fn is_usable(axis: &Axis, moves: &Measured, records: &[&Record], tuning: &mut Tuning) -> bool {
    let cycle = tuning.cycle_time;
    let mut refuse = |code, found: String, instead| tuning.verdicts.push(Verdict::refusal(code, found, instead));
    if let Some(other) = records.iter().find(|record| !is_same_interval(record.cycle, cycle)) {
        let found = format!("sampled every {} ms, the cycle of the set is {} ms", other.cycle * 1e3, cycle * 1e3);
        refuse(codes::OTHER_CYCLE, found, "record in the task that runs the block, in every cycle");
    }
    if moves.verdicts.iter().any(|verdict| verdict.code == codes::STAGES_ACTED) {
        let found = "stages acted while the moves were recorded: what others would do cannot be known".to_owned();
        refuse(codes::STAGES_ACTED, found, "record with all stages OFF or DRYRUN");
    }
    let v_motor = moves.record.as_ref().and_then(|record| record.get("v_motor"));
    let Some(v_motor) = v_motor else {
        let found = "stages look at v_motor, which is not recorded".to_owned();
        refuse(codes::NO_CHANNEL, found, "record v_motor, or name it with --map SCOPE=SIGNAL");
        return false;
    };
    let peak = peak(v_motor);
    let is_moving = |v: Option<&f64>| v.is_some_and(|v| libm::fabs(*v) > AT_REST * peak);
    if is_moving(v_motor.first()) || is_moving(v_motor.last()) {
        let found = "the recording of the moves does not begin and end at rest".to_owned();
        refuse(codes::NOT_AT_REST, found, "record from rest to rest");
    }
    if tuning.verdicts.is_empty() {
        records.iter().for_each(|record| of_another_time(axis, record, &mut tuning.verdicts));
    }
    tuning.verdicts.is_empty()
}

/// Refuses a `v_motor` that is not what the block took, as far as a dry run shows it: `v_add_calculated` is C times that,
/// with C of the stages that the axis has. Only this pair of channels shows a `v_motor` that is whole cycles late.
fn of_another_time(axis: &Axis, record: &Record, verdicts: &mut Vec<Verdict>) {
    let stages: Vec<Stage> = axis.ipc.stage.iter().flatten().cloned().collect();
    let pair = record.get("v_motor").zip(record.get("v_add_calculated"));
    let all_look_at_motor = !stages.is_empty() && stages.iter().all(|stage| looks_at_motor(stage.mode));
    let Some((v_motor, calculated)) = pair.filter(|_| all_look_at_motor) else { return };
    let (cycle, of) = (axis.cycle_time(), stage::controller(&stages, axis.cycle_time(), None));
    let c = |hz: f64| (of.stage)(libm::tan(std::f64::consts::PI * hz * cycle)).iter().sum();
    let Some(time) = offset::between(v_motor, calculated, cycle, c) else { return };
    if libm::fabs(time.seconds) > (LATE * cycle).larger(3.0 * time.error) {
        let found = format!(
            "v_add_calculated is {:.3} +-{:.3} ms later than the stages of the set make it from v_motor",
            time.seconds * 1e3,
            time.error * 1e3
        );
        let instead = "record v_motor in the cycle in which the block takes it, with the stages that are in the set";
        verdicts.push(Verdict::refusal(codes::CHANNEL_LATE, found, instead));
    }
}
