//! Proposes stages from recordings: recommended, strong, cautious, with the remaining part of each vibration; first ones if
//! the response of the drive is unknown. The search is in the crate `identification`. No file, nothing is written into a
//! set.
//!
//! ```text
//! chosen    the vibrations that get a stage
//! stage     a stage as parameters
//! proposal  the proposals, or the reasons against them
//! text      the report
//! ```

mod chosen;
mod proposal;
mod stage;
pub mod text;

pub use chosen::Chosen;
pub use identification::proposals::Kind;
pub use proposal::{Predicted, Proposal};
pub use stage::Stage;

use crate::measure::{Measured, Record, Verdict, is_same_interval};
use generator::blocks::Designed;
use generator::codes;
use identification::response::Lines;
use identification::segments;
use portable::peak;

/// A motor that is slower than this part of its peak is at rest.
const AT_REST: f64 = 0.05;

/// The response of the drive to be used.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Prefer {
    /// that of the excited recording, if there is one
    Excited,
    /// that of the set, or of the option that overrides it
    Set,
}

/// The proposals for an axis.
#[derive(Clone, Debug)]
pub struct Tuning {
    /// [s]
    pub cycle_time: f64,
    /// Kv [1/s]; `None` if the set does not state it
    pub position_gain: Option<f64>,
    /// the vibrations, in the order of the stages
    pub chosen: Vec<Chosen>,
    pub proposals: Vec<Proposal>,
    pub verdicts: Vec<Verdict>,
}

/// Proposes stages for an axis from its moves with the stages off, and from an excited recording of the same machine.
#[must_use]
pub fn tune(designed: &Designed, moves: &Measured, excited: Option<&Measured>, prefer: Prefer) -> Tuning {
    let axis = &designed.axis;
    let mut tuning = Tuning {
        cycle_time: axis.cycle_time(),
        position_gain: axis.drive.position_gain,
        chosen: Vec::new(),
        proposals: Vec::new(),
        verdicts: Vec::new(),
    };
    let all = [Some(moves), excited];
    if all.iter().flatten().any(|measured| measured.refuses()) {
        return tuning;
    }
    let records: Vec<&Record> = all.iter().flatten().filter_map(|measured| measured.record.as_ref()).collect();
    let (Some(record), true) = (moves.record.as_ref(), is_usable(moves, &records, &mut tuning)) else { return tuning };
    tuning.chosen = chosen::choose(moves, &mut tuning.verdicts);
    let of_set = axis.drive.response.as_ref().map(|measured| Lines::of(&measured.response));
    let of_excited = excited.and_then(|measured| Some(measured.excited.as_ref()?.lines.clone()));
    let lines = match prefer {
        Prefer::Excited => of_excited.or(of_set),
        Prefer::Set => of_set.or(of_excited),
    };
    if tuning.chosen.is_empty() {
        let left_out = if tuning.verdicts.is_empty() { "" } else { " that a stage can damp" };
        let found = format!("no vibration{left_out} at constant speed or after a ramp");
        let instead = "record a move that shows it, with x_command, v_motor and a sensor at the load";
        tuning.verdicts.push(Verdict::refusal(codes::NO_PROPOSAL, found, instead));
        return tuning;
    }
    let of = proposal::Task { axis, record, ramps: segments::ramps(&moves.segments).collect(), chosen: &tuning.chosen };
    tuning.proposals = match lines {
        Some(lines) => of.proposals(&lines, &mut tuning.verdicts),
        None => of.first(&mut tuning.verdicts),
    };
    tuning
}

/// Whether the effect of stages on the moves can be predicted.
fn is_usable(moves: &Measured, records: &[&Record], tuning: &mut Tuning) -> bool {
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
    tuning.verdicts.is_empty()
}
