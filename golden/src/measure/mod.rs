//! The properties of an axis in a recording: sampling, units, vibrations, the response to an excitation; and what it cannot
//! show. The mathematics is in the crate `identification`. No block, no file.
//!
//! ```text
//! verdict     restrictions of a recording
//! unit        units, stated or plausible
//! channels    columns -> channels: values and times
//! record      channels with common times; the command, segments, clipping
//! relations   offsets of channels; the gain of the position controller
//! excited     the response to an excitation
//! vibrations  lines, decays, poles; the side on which they enter
//! text        the report, and the response as CSV; picture: both over time and frequency
//! ```

mod channels;
mod excited;
pub mod picture;
mod record;
mod relations;
pub mod text;
mod unit;
mod verdict;
mod vibrations;

pub use channels::{Channel, Timing, read};
pub use excited::Excited;
pub use record::Record;
pub use record::is_same as is_same_interval;
pub use relations::Offset;
pub(crate) use relations::find_error_unit;
pub use unit::{Quantity, Unit};
pub use verdict::Verdict;
pub use vibrations::{Vibration, When, Windows};

use generator::codes;
use identification::excitation::Sequence;
use identification::segments::{self, Kind, Segment};

/// Whether a recording contains an excitation.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Excitation {
    /// if `v_excite` is not 0
    AsRecorded,
    /// yes; bits and clock that are not stated are taken from `v_excite`, else the default ones of the cycle
    Stated { bits: Option<u32>, clock: Option<u32> },
}

impl Excitation {
    /// The sequence, if anything of it is stated.
    fn sequence(self, cycle: f64) -> Option<Sequence> {
        let Self::Stated { bits, clock } = self else { return None };
        let default = Sequence::for_cycle(cycle);
        bits.or(clock)?;
        Sequence::new(bits.unwrap_or(default.bits()), clock.unwrap_or(default.clock()))
    }
}

/// The results of a recording.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// all recorded channels, as sampled
    pub channels: Vec<Channel>,
    /// `None` if they cannot be combined
    pub record: Option<Record>,
    /// segments of the command
    pub segments: Vec<Segment>,
    pub windows: Windows,
    pub offsets: Vec<Offset>,
    pub vibrations: Vec<Vibration>,
    pub excited: Option<Excited>,
    pub verdicts: Vec<Verdict>,
}

impl Measured {
    /// Whether a requested result is missing.
    #[must_use]
    pub fn refuses(&self) -> bool {
        self.verdicts.iter().any(|verdict| verdict.refuses)
    }
}

/// Measures channels. A cycle time [s] is the interval if the file does not state one; `other` is the result of an excited
/// recording of the same machine.
#[must_use]
pub fn measure(
    mut channels: Vec<Channel>,
    cycle_time: Option<f64>,
    excitation: Excitation,
    other: Option<&Measured>,
) -> Measured {
    for timing in channels.iter_mut().map(|channel| &mut channel.timing) {
        timing.interval = timing.interval.or(cycle_time);
    }
    let mut measured = Measured { channels, ..Measured::default() };
    let verdicts = &mut measured.verdicts;
    let Some(mut record) = combined(&measured.channels, cycle_time, verdicts) else { return measured };
    let fits = record.find_units(verdicts) & relations::positions_fit(&record, verdicts);
    find_error_unit(&record, None, verdicts);
    record.find_clipping(verdicts);
    record.find_outliers(verdicts);
    for channel in &mut measured.channels {
        channel.unit = record.channel(channel.signal).map_or(channel.unit, |known| known.unit);
    }
    let is_active = |signal| record.get(signal).is_some_and(|values| values.iter().any(|value| *value != 0.0));
    if is_active("v_add") {
        let instead = "record with all stages OFF or DRYRUN";
        verdicts.push(Verdict::note(codes::STAGES_ACTED, "v_add is not 0: stages acted", instead));
    }
    measured.offsets = relations::offsets(&record, verdicts);
    let is_excited = match excitation {
        Excitation::AsRecorded => is_active("v_excite"),
        Excitation::Stated { .. } => true,
    };
    if is_excited {
        let given = excitation.sequence(record.cycle);
        measured.excited = excited::measure(&record, given, fits, verdicts);
        measured.vibrations = measured.excited.as_ref().map(vibrations::of_response).unwrap_or_default();
    } else {
        of_moves(&mut measured, &record, other);
    }
    measured.record = Some(record);
    measured
}

/// The record that the channels make together; `None` after a refusal.
fn combined(channels: &[Channel], cycle_time: Option<f64>, verdicts: &mut Vec<Verdict>) -> Option<Record> {
    if !is_sampled(channels, verdicts) {
        return None;
    }
    let doubt = channels.iter().find_map(|channel| channel.timing.doubt.as_ref());
    if let Some(found) = doubt.filter(|_| cycle_time.is_none()) {
        let instead = "state the unit, as in `time [us]`; for 100 ns, --cycle-time TIME and --map NAME=-";
        verdicts.push(Verdict::note(codes::ASSUMED_UNIT, found, instead));
    }
    let record = Record::new(channels.to_vec(), verdicts);
    if record.is_none() {
        let instead = "record a move, and export all of its samples";
        verdicts.push(Verdict::refusal(codes::MEASURED_TOO_SHORT, "no sample that all channels have", instead));
    }
    record
}

/// Whether each channel has an interval and no gap.
fn is_sampled(channels: &[Channel], verdicts: &mut Vec<Verdict>) -> bool {
    let list =
        |of: &dyn Fn(&&Channel) -> bool| channels.iter().filter(of).map(|c| c.signal).collect::<Vec<_>>().join(", ");
    let without = list(&|channel| channel.timing.interval.is_none() && !channel.values.is_empty());
    if !without.is_empty() {
        let unusable = channels.iter().find_map(|channel| channel.timing.unusable.as_ref());
        let (why, instead) = match unusable {
            Some(why) => {
                (format!("; {why}"), "write the times as numbers with their unit, `time [s]`, or give --cycle-time")
            }
            None => (String::new(), "record the time too, or give --cycle-time"),
        };
        verdicts.push(Verdict::refusal(codes::NO_INTERVAL, format!("no sampling interval: {without}{why}"), instead));
    }
    let lost = || channels.iter().filter(|channel| channel.timing.missing > 0);
    if lost().next().is_some() {
        let of_each = lost().map(|channel| format!("{} of {}", channel.timing.missing, channel.signal));
        let before = lost().filter_map(|channel| channel.timing.first_gap).min();
        let before = before.map_or_else(String::new, |line| format!("; the first before line {line}"));
        let found = format!("samples are missing: {}{before}", of_each.collect::<Vec<_>>().join(", "));
        let instead = "record again with fewer channels or a larger buffer, or cut the file at the gap";
        verdicts.push(Verdict::refusal(codes::SAMPLES_LOST, found, instead));
    }
    if channels.is_empty() {
        let instead = "record v_command, v_motor and a_load, or name them with --map SCOPE=SIGNAL";
        verdicts.push(Verdict::refusal(codes::NO_CHANNEL, "no channel that is measured", instead));
    }
    without.is_empty() && lost().next().is_none() && !channels.is_empty()
}

/// The results of moves without an excitation.
fn of_moves(measured: &mut Measured, record: &Record, other: Option<&Measured>) {
    let verdicts = &mut measured.verdicts;
    let instead = "record x_command or v_command with a_load or v_motor, or name them with --map SCOPE=SIGNAL";
    let Some((command, moves)) = record.command().filter(|_| !vibrations::signals(record).is_empty()) else {
        let found = "segments need a command, and vibrations a channel that shows them";
        verdicts.push(Verdict::refusal(codes::NO_CHANNEL, found, instead));
        return;
    };
    if !moves {
        let instead = "record ramps, at least 1.5 s at constant speed, and 1.2 s after the last ramp";
        verdicts.push(Verdict::refusal(codes::MEASURED_AT_REST, "the command does not move the axis", instead));
        return;
    }
    measured.segments = segments::of(&command);
    measured.windows = Windows::of(&measured.segments, &command, record.cycle);
    let Windows { driving, ramps } = &measured.windows;
    if driving.is_empty() && ramps.is_empty() {
        let count = |kind| measured.segments.iter().filter(|segment| segment.kind == kind).count();
        let found = format!(
            "{:.2} s with {} ramps: nowhere 0.55 s at constant speed or at rest after a ramp",
            record.samples() as f64 * record.cycle,
            count(Kind::Accelerating)
        );
        let instead = "record at least 1.5 s at constant speed, and 1.2 s after the last ramp";
        verdicts.push(Verdict::refusal(codes::MEASURED_TOO_SHORT, found, instead));
        return;
    }
    let kv = relations::position_gain(record);
    measured.vibrations = vibrations::of_moves(record, &measured.windows, kv);
    vibrations::find_doubts(&measured.vibrations, verdicts);
    let excited = other.and_then(|other| other.record.as_ref().zip(other.excited.as_ref()));
    vibrations::find_sides(&mut measured.vibrations, record, excited, verdicts);
}
