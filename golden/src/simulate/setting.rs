//! The loop of a run: machine, position controller, moves, and the block in it; and the measurements.

use super::of_plant::OfPlant;
use super::ripple::Ripple;
use super::row::{Moved, Row};
use crate::case::named_block;
use crate::drive::{AtLimit, AxisDrive, margins};
use crate::subject::Subject;
use generator::analysis::looks_at_load;
use generator::blocks::Designed;
use machine::Machine;
use machine::closed_loop::{self, Position, Record, Signals, UM};
use machine::drive::Setup;
use machine::measure::{self, figures};
use machine::plant::{DEMONSTRATION, Plant};
use machine::sequence::Sequence;
use portable::Extreme;
use portable::peak;

/// Mode of the block (P-AXIS-00758).
pub(super) const OFF: f64 = 0.0;
pub(super) const ON: f64 = 1.0;
/// Minimum number of periods of a ripple at constant speed, and the settling time before them [s].
const PERIODS: f64 = 20.0;
const BEFORE: f64 = 0.4;

/// The axis with only one of its stages, or with none.
pub(super) fn only(designed: &Designed, stage: Option<usize>) -> Designed {
    let mut axis = designed.axis.clone();
    for (index, of) in axis.ipc.stage.iter_mut().enumerate() {
        if Some(index) != stage {
            *of = None;
        }
    }
    Designed::from(axis)
}

/// The machine in the loop.
pub(super) enum Moving {
    Drive(Box<AxisDrive>),
    Plant(Box<OfPlant>),
}

/// The common data of all runs.
pub(super) struct Setting {
    pub(super) moving: Moving,
    pub(super) position: Position,
    pub(super) sequence: Sequence,
    pub(super) cycle: f64,
    frequencies: Vec<f64>,
    /// cycles at rest, in which the block fades in
    fade: usize,
}

impl Setting {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a fade is below 2^24 cycles")]
    pub(super) fn new(designed: &Designed, moved: Moved, dwell: Option<f64>, stages: &[(usize, f64)]) -> Self {
        let axis = &designed.axis;
        let (cycle, kv) = (axis.cycle_time(), Position::DEMONSTRATION.kv);
        let lowest = stages.iter().map(|(_, f0)| *f0).fold(f64::INFINITY, f64::smaller);
        let usual = Sequence::DEMONSTRATION.dwell;
        let (moving, kv, usual) = match moved {
            Moved::Demonstration => (Moving::Plant(Box::new(OfPlant::new(&plant(cycle), kv))), kv, usual),
            Moved::Drive => {
                let drive = AxisDrive::of(designed, Setup::DELAY, kv);
                let kv = drive.position_gain;
                (Moving::Drive(Box::new(drive)), kv, usual.larger(BEFORE + PERIODS / lowest))
            }
        };
        let speed = Sequence::DEMONSTRATION.speed.smaller(axis.ipc.v_max / UM);
        let sequence = Sequence { speed, dwell: dwell.unwrap_or(usual), ..Sequence::DEMONSTRATION };
        // Tuned weights reach their values within a fade, and the block is on after another one.
        let fade = (2.0 * axis.ipc.fade_time() / cycle).ceil() as usize + 1;
        let frequencies = stages.iter().map(|(_, f0)| *f0).collect();
        let position = Position { kv, ..Position::DEMONSTRATION };
        Self { moving, position, sequence, cycle, frequencies, fade }
    }

    /// The deviation of the filter of a measured response, and its frequency [Hz].
    pub(super) fn deviation(&self) -> Option<[f64; 2]> {
        match &self.moving {
            Moving::Drive(drive) => drive.deviation(),
            Moving::Plant(_) => None,
        }
    }

    /// Runs moves from rest, with what is added to the command in each cycle.
    pub(super) fn run(&self, sequence: &Sequence, add: &mut dyn FnMut(&Signals) -> f64) -> Record {
        closed_loop::run(self.machine(), &self.position, sequence, add)
    }

    /// A time [s] in cycles.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a time of minutes")]
    pub(super) fn cycles(&self, time: f64) -> usize {
        libm::ceil(time / self.cycle) as usize
    }

    fn machine(&self) -> Box<dyn Machine> {
        match &self.moving {
            Moving::Plant(_) => Box::new(plant(self.cycle).at_rest()),
            Moving::Drive(drive) => Box::new(Ripple::new(drive.machine(), self.frequencies.clone(), drive.is_in_cnc())),
        }
    }

    /// One run from rest, after the block's fade.
    pub(super) fn row(&self, name: &str, designed: &Designed, mode: f64) -> Result<Row, String> {
        let mut subject = block(designed, mode)?;
        let mut error_id = None;
        let mut limited = Vec::new();
        // With position control in the drive SET_POINT takes the planned velocity.
        let in_cnc = designed.axis.control.commands_by_position();
        let planned = self.sequence.planned(self.cycle).v;
        let rest = std::iter::repeat_n(0.0, self.fade);
        let mut v_planned = rest.chain(planned).map(|v| v * UM);
        let mut cycle = |signals: &Signals| {
            let v_planned = v_planned.next().unwrap_or(0.0);
            let v_command = if in_cnc { signals.v_command } else { v_planned };
            let v_add = subject.cycle(&Signals { v_command, ..*signals });
            subject.record_anew();
            if subject.get("fault") != 0.0 || subject.get("tripped") != 0.0 {
                error_id = error_id.or(Some(subject.get("error_id")));
            }
            limited.push(subject.get("limited") != 0.0);
            v_add
        };
        (0..self.fade).for_each(|_| _ = cycle(&Signals::default()));
        let record = self.run(&self.sequence, &mut cycle);
        let loop_of = if mode == ON { designed.clone() } else { only(designed, None) };
        let (is_judged, ms) = match &self.moving {
            Moving::Plant(_) if loop_of.stage.iter().flatten().any(|of| looks_at_load(of.stage.mode)) => (false, None),
            Moving::Plant(of_plant) => (true, of_plant.ms(&loop_of)),
            Moving::Drive(drive) => (true, margins::ms(&loop_of, &drive.model)),
        };
        Ok(Row {
            name: name.to_owned(),
            amplitudes: self.amplitudes(&record),
            following_error: measure::following_error(&record) * 1e3,
            peak_v_add: peak(&record.v_add),
            ms,
            is_judged,
            at_limit: at_limit(&record, &limited[self.fade..]),
            error_id,
            record,
        })
    }

    /// The amplitudes of a row.
    fn amplitudes(&self, record: &Record) -> Vec<f64> {
        match self.moving {
            Moving::Plant(_) => {
                let of = figures(record);
                vec![of.at_speed, of.at_ramps, of.ring_down]
            }
            Moving::Drive(_) => self.frequencies.iter().map(|f0| of_ripple(record, *f0)).collect(),
        }
    }
}

/// The block `ipc` in a mode, with all its weights.
pub(super) fn block(designed: &Designed, mode: f64) -> Result<Subject, String> {
    let mut subject = Subject::start(designed, &named_block(designed, "ipc")?);
    let signals = subject.inputs.shape.signals.iter().map(|signal| signal.name.clone());
    let tuned: Vec<String> = signals.filter(|name| name.starts_with("tuning_")).collect();
    tuned.iter().for_each(|name| _ = subject.set(name, 1.0));
    subject.set("mode", mode);
    Ok(subject)
}

/// The demonstration plant at a cycle of the CNC [s].
fn plant(cycle: f64) -> Plant {
    Plant { cycle, ..DEMONSTRATION }
}

/// The amplitude of v_motor at a frequency at constant speed, mean of both directions [mm/s].
fn of_ripple(record: &Record, f0: f64) -> f64 {
    let (mut sum, mut ways) = (0.0, 0.0);
    for window in measure::dwells(record) {
        let v = measure::without_mean(record.signals[window].iter().map(|of| of.v_motor / 1e3));
        sum += measure::amplitude(&v, record.cycle, [0.99 * f0, 1.01 * f0]);
        ways += 1.0;
    }
    sum / ways
}

/// The time of v_add at its limit without a ramp as the reason [s].
fn at_limit(record: &Record, limited: &[bool]) -> f64 {
    let mut at_limit = AtLimit::new(record.cycle);
    for (n, is_limited) in limited.iter().enumerate() {
        at_limit.count(record.ramps.iter().any(|[from, to]| (*from..*to).contains(&n)), *is_limited);
    }
    at_limit.time()
}
