//! The response in a recording with an excitation: its periods, its lines, its dead time. No vibration.

use super::record::Record;
use super::verdict::Verdict;
use generator::codes;
use generator::diagnostics::Severity;
use generator::response_file;
use identification::dead_time::{self, Channels};
use identification::excitation::{Excitation, Sequence};
use identification::offset::Time;
use identification::response::{FEWEST_PERIODS, LARGEST_UNCERTAINTY, Lines, Refused};
use portable::{Extreme, peak};
use stability::{Complex64, magnitude};
use std::ops::Range;

/// Clocks [cycles] and bits of the sequences that are tried on `v_excite`.
const CLOCKS: std::ops::RangeInclusive<u32> = 1..=40;
const BITS: std::ops::RangeInclusive<u32> = 7..=15;
/// A sequence is that of the recording if this part of the signs agrees.
const SAME_SIGNS: f64 = 0.99;
/// Two periods of changes are equal above this correlation; for neighbours of one excitation it is relative to the largest.
const REPEATS: f64 = 0.5;
const OF_LARGEST: f64 = 0.98;
/// A larger relative error makes a line useless for the dead time, which is known only if at most this part of the lines up
/// to this part of half the sampling frequency is useless.
const VAGUE: f64 = 0.25;
const MOST_VAGUE: f64 = 0.1;
const NEEDED: f64 = 0.8;

/// The result of an excitation.
#[derive(Clone, Debug)]
pub struct Excited {
    pub sequence: Sequence,
    /// the samples of the measured periods
    pub measured: Range<usize>,
    /// as measured and smoothed, up to half the frequency of the clocks
    pub raw: Lines,
    pub lines: Lines,
    /// `None` if the lines do not show it
    pub dead_time: Option<Time>,
    /// `a_load`/`v_motor`, smoothed
    pub load: Option<Lines>,
}

impl Excited {
    /// Number of measured periods M.
    #[must_use]
    pub fn periods(&self) -> usize {
        self.measured.len() / self.sequence.period()
    }

    /// The velocity ratio of load and motor at a frequency [Hz].
    pub(super) fn load_at(&self, hz: f64, cycle: f64) -> Option<Complex64> {
        let load = self.load.as_ref()?;
        let [from, to] = load.band()?;
        (from..=to).contains(&hz).then_some(())?;
        load.response(cycle).map(|response| response.value(hz))
    }
}

/// Measures the response. A sequence that is not given is taken from `v_excite`, else the default one of the cycle is used.
pub(super) fn measure(
    record: &Record,
    given: Option<Sequence>,
    fits: bool,
    verdicts: &mut Vec<Verdict>,
) -> Option<Excited> {
    let (Some(v_cmd), Some(v_motor)) = (record.v_cmd(), record.get("v_motor")) else {
        let found = "a response needs v_cmd (or v_command) and v_motor";
        verdicts.push(Verdict::refusal(codes::NO_CHANNEL, found, "record both, or name them with --map SCOPE=SIGNAL"));
        return None;
    };
    let place = match record.get("v_excite").filter(|excite| peak(excite) > 0.0) {
        Some(excite) => of_excitation(excite, record.cycle, given),
        None => of_command(&v_cmd, given.unwrap_or_else(|| Sequence::for_cycle(record.cycle))),
    };
    let Some((sequence, measured)) = place else {
        let found = "no periods of the excitation are found";
        let instead = "give --excitation BITSxCLOCK as the recording was made, and record v_excite and all periods";
        verdicts.push(Verdict::refusal(codes::NOT_EXCITED, found, instead));
        return None;
    };
    let unit = record.velocity_ratio();
    let motor: Vec<f64> = v_motor[measured.clone()].iter().map(|v| v * unit).collect();
    let all = Lines::measured(&sequence, record.cycle, &v_cmd[measured.clone()], &motor);
    let all = all.map_err(|refused| verdicts.push(said(refused, &measured, record.cycle))).ok()?;
    let load = record.get("a_load").and_then(|a_load| {
        Lines::of_periods(&sequence, record.cycle, &v_motor[measured.clone()], &a_load[measured.clone()]).ok()
    });
    let half = sequence.half_clock(record.cycle);
    let dead_time = dead_time_of(&all, record.cycle);
    let raw = all.up_to(half);
    let lines = raw.smoothed(record.cycle);
    let load = load.map(|load| load.up_to(half).smoothed(record.cycle));
    let is_of_task = dead_time_is_possible(dead_time, record.cycle, verdicts);
    find_uncertain(&lines, verdicts);
    let is_alone = has_no_foreign_line(&raw, verdicts);
    let excited = Excited { sequence, measured, raw, lines, dead_time, load };
    (fits && follows(&excited.lines, verdicts) && is_of_task && is_alone).then_some(excited)
}

/// Whether the motor follows slow commands.
fn follows(lines: &Lines, verdicts: &mut Vec<Verdict>) -> bool {
    let said = response_file::of_lowest_lines(&lines.hz, &lines.response, &lines.error);
    let refuses = said.iter().any(|of| of.severity == Severity::Error);
    verdicts.extend(said.into_iter().map(Verdict::from));
    !refuses
}

/// The reason why there is no response.
fn said(refused: Refused, measured: &Range<usize>, cycle: f64) -> Verdict {
    match refused {
        Refused::Reverses(at) => Verdict::refusal(
            codes::MOTOR_REVERSES,
            format!("v_motor changes its sign at {:.3} s, while it is excited", (measured.start + at) as f64 * cycle),
            "excite while the axis moves at constant speed, 2.5 times the amplitude or faster",
        ),
        Refused::TooFewPeriods(periods) => too_few(periods),
        Refused::NotPeriods => too_few(0),
    }
}

fn too_few(periods: usize) -> Verdict {
    Verdict::refusal(
        codes::MEASURED_TOO_SHORT,
        format!("{periods} measured periods of the excitation; at least {FEWEST_PERIODS} are needed"),
        "record 8 periods after the one in which the axis settles",
    )
}

/// The sequence and its measured periods, from the excitation. The excitation rises at its start, and falls after its last
/// period.
fn of_excitation(excite: &[f64], cycle: f64, given: Option<Sequence>) -> Option<(Sequence, Range<usize>)> {
    let start = excite.iter().position(|value| *value != 0.0)?;
    let end = excite.iter().rposition(|value| *value != 0.0)? + 1;
    // The first sample of a fade is 0.
    let start = start.saturating_sub(1);
    let signs = &excite[start..end];
    let is_it = |sequence: &Sequence| {
        let count = signs.len().min(2 * sequence.period());
        let same = signs.iter().zip(sequence.signs()).take(count).filter(|(value, sign)| **value * sign > 0.0).count();
        count > 0 && same as f64 >= SAME_SIGNS * count as f64
    };
    let default = Sequence::for_cycle(cycle);
    let sequence = match given {
        Some(sequence) => Some(sequence).filter(is_it),
        None => std::iter::once(default)
            .chain(CLOCKS.flat_map(|clock| BITS.filter_map(move |bits| Sequence::new(bits, clock))))
            .find(is_it),
    }?;
    let period = sequence.period();
    let fade = Excitation { sequence, cycle_time: cycle, amplitude: 1.0, periods: 0 }.samples().count() - period;
    let full = (end - start).saturating_sub(fade);
    let periods = (full / period).saturating_sub(1);
    let from = (start + period).min(excite.len());
    Some((sequence, from..(from + periods * period).min(excite.len())))
}

/// The sequence and its measured periods from the command alone: the part where its changes repeat with the period, and are
/// those of the sequence.
fn of_command(v_cmd: &[f64], sequence: Sequence) -> Option<(Sequence, Range<usize>)> {
    let period = sequence.period();
    let changes: Vec<f64> = std::iter::once(0.0).chain(v_cmd.windows(2).map(|pair| pair[1] - pair[0])).collect();
    let last = changes.len().checked_sub(2 * period)?;
    let product = |n: usize, lag: usize| changes[n] * changes[n + lag];
    let sum = |from: usize, lag: usize| (from..from + period).map(|n| product(n, lag)).sum::<f64>();
    let [mut same, mut here, mut there] = [sum(0, period), sum(0, 0), sum(period, 0)];
    let mut correlation = Vec::with_capacity(last + 1);
    for n in 0..=last {
        let power = (here * there).larger(0.0).sqrt();
        correlation.push(if power > 0.0 { same / power } else { 0.0 });
        if n < last {
            same += product(n + period, period) - product(n, period);
            here += product(n + period, 0) - product(n, 0);
            there += product(n + 2 * period, 0) - product(n + period, 0);
        }
    }
    let largest = correlation.iter().copied().fold(0.0, f64::larger);
    (largest > REPEATS).then_some(())?;
    let repeats = |value: &f64| *value >= OF_LARGEST * largest;
    let first = correlation.iter().position(repeats)?;
    let end = correlation.iter().rposition(repeats)? + 2 * period;
    let from = first + period;
    let measured = from..from + (end.saturating_sub(from)) / period * period;
    is_of(&changes[from..(from + period).min(changes.len())], &sequence).then_some((sequence, measured))
}

/// Whether a period of changes is that of the sequence, starting at any of its samples.
fn is_of(changes: &[f64], sequence: &Sequence) -> bool {
    let period = sequence.period();
    let signs: Vec<f64> = sequence.signs().take(period + 1).collect();
    let steps: Vec<(usize, f64)> =
        (0..period).map(|n| (n, signs[n + 1] - signs[n])).filter(|(_, step)| *step != 0.0).collect();
    let power = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
    let both = power(&mut changes.iter().copied()) * power(&mut steps.iter().map(|(_, step)| *step));
    let at = |shift: usize| steps.iter().map(|(n, step)| step * changes[(n + shift) % changes.len()]).sum::<f64>();
    changes.len() == period && (0..period).any(|shift| at(shift) >= REPEATS * both.sqrt())
}

/// The dead time of lines. Lines that are too uncertain, near half the sampling frequency where a clock is constant, get the
/// last certain magnitude: these magnitudes hardly affect the phases below.
fn dead_time_of(raw: &Lines, cycle: f64) -> Option<Time> {
    let mut lines = raw.smoothed(cycle);
    let is_vague = |k: &usize| lines.error[*k] > VAGUE * magnitude(lines.response[*k]);
    let needed = lines.hz.partition_point(|hz| *hz < NEEDED * 0.5 / cycle);
    let vague = (0..needed).filter(is_vague).count();
    (vague as f64 <= MOST_VAGUE * needed as f64).then_some(())?;
    let mut last = 1.0;
    for k in 0..lines.hz.len() {
        let size = magnitude(lines.response[k]);
        if size > 0.0 && lines.error[k] <= VAGUE * size {
            last = size;
        } else if size > 0.0 {
            lines.response[k] *= last / size;
            lines.error[k] = 1e3 * last;
        }
    }
    dead_time::of(&lines, cycle)
}

/// Whether the task of the block may have recorded both channels.
fn dead_time_is_possible(time: Option<Time>, cycle: f64, verdicts: &mut Vec<Verdict>) -> bool {
    let state =
        "state it: both channels are recorded by the task that runs the block, in the cycle in which it uses them";
    let Some(time) = time else {
        let found =
            "the dead time is not known, so that nothing shows whether v_cmd and v_motor were recorded together";
        verdicts.push(Verdict::note(codes::WHOLE_CYCLES, found, state));
        return true;
    };
    let ms = time.seconds * 1e3;
    match Channels::of(time.seconds, cycle) {
        Channels::Whole(cycles) => {
            let found =
                format!("dead time {ms:.3} ms, {cycles} cycles: a channel that is whole cycles late looks the same");
            verdicts.push(Verdict::note(codes::WHOLE_CYCLES, found, state));
            true
        }
        wrong => {
            let what = if wrong == Channels::TooShort { "below one cycle" } else { "not a whole number of cycles" };
            let found = format!("dead time {ms:.3} ms, {what} of {} ms", cycle * 1e3);
            let instead = "record v_cmd and v_motor in the task that runs the block";
            verdicts.push(Verdict::refusal(codes::NOT_OF_THE_TASK, found, instead));
            false
        }
    }
}

/// Whether the excitation makes all lines. What turns with the axis, as the mesh of a pinion, makes a line of its
/// own, which repeats from period to period where its frequency is near a multiple of 1/(N T): its standard error is
/// small, and it is wrong by much. A line is foreign if it is away from the middle of its neighbours by half of it,
/// by 5 standard errors of those around, and by three times what these are away from each other.
fn has_no_foreign_line(lines: &Lines, verdicts: &mut Vec<Verdict>) -> bool {
    const AROUND: usize = 4;
    let [part, errors_away, steps_away] = [0.5, 5.0, 3.0];
    let p = &lines.response;
    let is_foreign = |k: &usize| {
        let mut errors: Vec<f64> = (k - AROUND..=k + AROUND).filter(|i| i != k).map(|i| lines.error[i]).collect();
        errors.sort_by(f64::total_cmp);
        let middle = (p[k - 1] + p[k + 1]) / 2.0;
        let away = magnitude(p[*k] - middle);
        let steps = [[k - 2, k - 1], [k + 1, k + 2], [k - 1, k + 1]].map(|[a, b]| magnitude(p[a] - p[b]));
        let step = steps.into_iter().fold(0.0, f64::larger);
        away > part * magnitude(middle) && away > errors_away * errors[AROUND] && away > steps_away * step
    };
    let foreign = (AROUND..p.len().saturating_sub(AROUND)).find(is_foreign);
    if let Some(k) = foreign {
        let found = format!("at {:.1} Hz something else than the excitation makes a line", lines.hz[k]);
        let instead = "excite at another speed, so that the mesh frequency (speed/pitch) is below the band";
        verdicts.push(Verdict::refusal(codes::FOREIGN_LINE, found, instead));
    }
    foreign.is_none()
}

/// Bands in which nothing can be proposed.
fn find_uncertain(lines: &Lines, verdicts: &mut Vec<Verdict>) {
    let is_certain = |k: usize| 2.0 * lines.error[k] < LARGEST_UNCERTAINTY * magnitude(lines.response[k]);
    let mut bands: Vec<[f64; 2]> = Vec::new();
    let mut is_open = false;
    for (k, hz) in lines.hz.iter().enumerate() {
        match (is_certain(k), is_open, bands.last_mut()) {
            (false, true, Some(band)) => band[1] = *hz,
            (false, ..) => bands.push([*hz; 2]),
            (true, ..) => {}
        }
        is_open = !is_certain(k);
    }
    if bands.is_empty() {
        return;
    }
    const MOST: usize = 5;
    let shown: Vec<String> = bands.iter().take(MOST).map(|[from, to]| format!("{from:.1} to {to:.1} Hz")).collect();
    let more = if bands.len() > MOST { ", ..." } else { "" };
    let found = format!("two standard errors are half of the response or more: {}{more}", shown.join(", "));
    verdicts.push(Verdict::note(codes::UNCERTAIN_LINES, found, "measure more periods, or with a larger amplitude"));
}
