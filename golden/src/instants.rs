//! The sampling times of a recording, compared with the cycle of the block: a sample is one cycle.

use crate::mistake::Mistake;
use crate::table::{Column, TimeColumn, Unit, listed};
use generator::codes;
use portable::Extreme;
use std::ops::{Range, RangeInclusive};

/// The times of one column, from the first one on.
pub(crate) struct Instants<'t> {
    pub column: TimeColumn<'t>,
    /// the first time, in 10^-9 of the column's unit
    first: Option<i128>,
    /// times since the first one, in 10^-9 of the column's unit
    since: Vec<i64>,
    /// the line of each
    lines: Vec<usize>,
    /// a cell that is not a number, and its line: then the times are unknown
    text: Option<(String, usize)>,
    /// whether the row that was read last has the time of the row before it
    pub repeats: bool,
}

/// The unit of time stamps [ns], and their values of the years 1917 to 2234. Milliseconds are smaller; nanoseconds since 1970
/// are larger.
const FILE_TIME: i64 = 100;
const FILE_TIMES: Range<i128> = 100_000_000_000_000_000..200_000_000_000_000_000;
/// Steps on both sides of a long or a short one that show whether samples are missing there, or the times jitter.
const AROUND: usize = 5;
/// The cycle of a controller [ns].
const CYCLES: RangeInclusive<f64> = 31e3..=30e6;
/// Possible units of a time without a unit in its name.
const UNSAID: [(i64, &str); 4] = [(1_000_000_000, "s"), (1_000_000, "ms"), (1_000, "us"), (1, "ns")];

impl<'t> Instants<'t> {
    pub(crate) fn of(column: TimeColumn<'t>) -> Self {
        Self { column, first: None, since: Vec::new(), lines: Vec::new(), text: None, repeats: false }
    }

    /// Reads one cell of the column; an empty one is not a time, and a repeated one is not another time.
    pub(crate) fn read(&mut self, cell: &str, line: usize) {
        self.repeats = false;
        if cell.is_empty() || self.text.is_some() {
            return;
        }
        let Some(time) = billionths(cell) else { return self.text = Some((cell.escape_default().to_string(), line)) };
        let first = *self.first.get_or_insert(time);
        let since = i64::try_from(time - first).unwrap_or(i64::MAX);
        self.repeats = self.since.last() == Some(&since);
        if !self.repeats {
            self.since.push(since);
            self.lines.push(line);
        }
    }

    /// Times that run backwards.
    pub(crate) fn backwards(&self) -> Option<Mistake> {
        let at = self.since.windows(2).position(|pair| pair[1] < pair[0]).filter(|_| self.text.is_none())?;
        let found = format!("the time{} runs backwards: it is smaller than in line {}", self.called(), self.lines[at]);
        let mistake = Mistake::new([self.lines[at + 1], 1], found, "times that rise").coded(codes::UNUSABLE_TIMES);
        Some(mistake.instead(format!("cut the file before this line{}", self.without())))
    }

    /// Samples that differ, of these columns, although they have one time; the place is that of the first one.
    pub(crate) fn several(&self, place: [usize; 2], columns: &str, count: usize) -> Mistake {
        let found =
            format!("other values of {columns} at the time{} of the row before: in {count} rows", self.called());
        let mistake = Mistake::new(place, found, "one sample at a time, which may be repeated");
        let remedy = format!("export the times with more digits{}", self.without());
        mistake.coded(codes::UNUSABLE_TIMES).instead(remedy)
    }

    /// Its name after `the time`: none in an export.
    fn called(&self) -> String {
        let name = self.column.name.escape_default();
        if self.column.name.is_empty() { String::new() } else { format!(" `{name}`") }
    }

    /// The remedy that leaves the times out, if that is possible.
    fn without(&self) -> String {
        let name = self.column.name;
        if name.is_empty() { String::new() } else { format!(", or leave the times out:{}", option(name)) }
    }

    /// Why the times show no sampling interval.
    pub(crate) fn unusable(&self) -> Option<String> {
        match (&self.text, self.step()) {
            (Some((cell, line)), _) => Some(format!("the time `{cell}` in line {line} is not a number")),
            (None, None) => Some(format!("the time{} does not go on", self.called())),
            (None, Some(_)) if self.stated_unit().or(self.plausible_unit().map(|(unit, _)| unit)).is_none() => {
                Some(format!("the time{} has no unit, and no usual one fits its steps", self.called()))
            }
            (None, Some(_)) => None,
        }
    }

    /// Nanoseconds per unit of the column; for a time without a unit, the unit in which the step is the block's cycle.
    fn unit(&self, cycle_time_ns: u32) -> Option<i64> {
        self.stated_unit().or_else(|| {
            let step = self.step().filter(|_| self.column.unit == Unit::Unsaid)?;
            let is_cycle = |unit: i64| is_near(nanoseconds(step, unit), f64::from(cycle_time_ns));
            UNSAID.iter().map(|(unit, _)| *unit).find(|unit| is_cycle(*unit))
        })
    }

    /// Nanoseconds of the unit in the name, or that the size of the first time shows.
    fn stated_unit(&self) -> Option<i64> {
        match self.column.unit {
            Unit::Nanoseconds(unit) => Some(unit),
            _ if FILE_TIMES.contains(&(self.first? / 1_000_000_000)) => Some(FILE_TIME),
            Unit::OfExport => Some(1_000_000),
            Unit::Unsaid => None,
        }
    }

    /// The usual step: the median of the increasing steps.
    fn step(&self) -> Option<i64> {
        let mut steps: Vec<i64> =
            self.since.windows(2).map(|pair| pair[1].saturating_sub(pair[0])).filter(|step| *step > 0).collect();
        let middle = steps.len() / 2;
        (!steps.is_empty()).then(|| *steps.select_nth_unstable(middle).1)
    }

    /// The times since the first one, and the usual step [s]. A missing unit is the one in which the usual step is the cycle of
    /// a controller; `None` if there are no times, or no such unit.
    pub(crate) fn seconds(&self) -> Option<(Vec<f64>, f64)> {
        let step = self.step().filter(|_| self.text.is_none())?;
        let unit = self.stated_unit().or_else(|| Some(self.plausible_unit()?.0))?;
        let seconds = |time| nanoseconds(time, unit) / 1e9;
        Some((self.since.iter().copied().map(seconds).collect(), seconds(step)))
    }

    fn plausible_unit(&self) -> Option<(i64, &'static str)> {
        let step = self.step()?;
        UNSAID.into_iter().find(|(unit, _)| CYCLES.contains(&nanoseconds(step, *unit)))
    }

    /// What is assumed for times without a unit, if 100 ns are plausible too.
    pub(crate) fn doubt(&self) -> Option<String> {
        let step = self.step().filter(|step| self.text.is_none() && CYCLES.contains(&nanoseconds(*step, FILE_TIME)))?;
        let (unit, name) = self.plausible_unit().filter(|_| self.stated_unit().is_none())?;
        let interval = nanoseconds(step, unit) / 1e6;
        let of = self.column.name.escape_default();
        Some(format!("`{of}` has no unit: {name} are assumed, a sample every {interval} ms; 100 ns are possible too"))
    }

    /// The number of cycles of each step: 1, or 0 and more where samples are repeated or missing. Times that jitter return to
    /// even sampling: around such a step, the means of the times are as far apart as in other places.
    #[expect(clippy::cast_precision_loss, reason = "a part of a step")]
    fn cycles(&self, usual: f64) -> impl Iterator<Item = f64> {
        let time = move |at: usize| self.since[at] as f64 / usual;
        (1..self.since.len()).map(move |at| {
            let step = time(at) - time(at - 1);
            let [before, after] = [at.min(AROUND), (self.since.len() - at).min(AROUND)];
            let mean = |from: usize, count: usize| (from..from + count).map(time).sum::<f64>() / count as f64;
            let apart = || mean(at, after) - mean(at - before, before) - (before + after) as f64 / 2.0;
            let is_one = (0.5..1.5).contains(&step) || libm::fabs(apart()) < 0.5;
            if is_one { 1.0 } else { libm::round(step) }
        })
    }

    /// The number of usual steps in each step, at least 1.
    #[expect(clippy::cast_precision_loss, reason = "a part of a step")]
    pub(crate) fn usual_cycles(&self) -> Vec<f64> {
        self.step().map_or(Vec::new(), |step| self.cycles(step as f64).map(|cycles| cycles.larger(1.0)).collect())
    }

    /// The largest distance of a time from even sampling, as a part of the usual step, and its line. A gap counts whole steps.
    #[expect(clippy::cast_precision_loss, reason = "a part of a step")]
    pub(crate) fn drift(&self) -> Option<(f64, usize)> {
        let step = self.step().filter(|_| self.text.is_none())? as f64;
        let count = |count: &mut f64, cycles: f64| {
            *count += cycles;
            Some(*count)
        };
        let counts: Vec<f64> = self.usual_cycles().into_iter().scan(0.0, count).collect();
        let mean = *self.since.last()? as f64 / counts.last()?;
        let of =
            |((count, time), line): ((&f64, &i64), &usize)| (libm::fabs(*time as f64 - count * mean) / step, *line);
        let all = counts.iter().zip(&self.since[1..]).zip(&self.lines[1..]).map(of);
        all.reduce(|largest, other| if other.0 > largest.0 { other } else { largest })
    }

    /// The line of each time.
    pub(crate) fn lines(&self) -> &[usize] {
        &self.lines
    }

    /// The time in a line [ns].
    pub(crate) fn at(&self, line: usize) -> Option<i128> {
        let unit = self.stated_unit().filter(|_| self.text.is_none())?;
        let since = self.since[self.lines.binary_search(&line).ok()?];
        Some((self.first? + i128::from(since)) * i128::from(unit) / 1_000_000_000)
    }
}

/// A number in units of 10^-9, exactly if it is an integer.
fn billionths(cell: &str) -> Option<i128> {
    if let Ok(whole) = cell.parse::<i64>() {
        return Some(i128::from(whole) * 1_000_000_000);
    }
    let value = cell.parse::<f64>().ok().filter(|value| value.is_finite() && value.abs() < 1e18)?;
    #[expect(clippy::cast_possible_truncation, reason = "below 1e27")]
    Some(libm::round(value * 1e9) as i128)
}

#[expect(clippy::cast_precision_loss, reason = "a step is compared with a tolerance")]
fn nanoseconds(step: i64, unit: i64) -> f64 {
    step as f64 * unit as f64 / 1e9
}

/// Times are rounded to few digits: 0.063 ms for 0.0625 ms.
fn is_near(found: f64, right: f64) -> bool {
    (found - right).abs() <= 0.03 * right
}

/// The errors in the sampling times of the columns: one message about the intervals, one about each column of times with
/// gaps.
pub(crate) fn mistakes(columns: &[&Column<'_>], times: &[Instants<'_>], cycle_time_ns: u32) -> Vec<Mistake> {
    let cycle = f64::from(cycle_time_ns) / 1e6;
    let interval = |column: &&Column<'_>| -> Option<(String, [usize; 2])> {
        let said = column.sample_time.and_then(|(text, place)| {
            let time = text.replace(',', ".").parse::<f64>().ok()?;
            (!is_near(time, cycle)).then(|| (format!("{time} ms"), place))
        });
        said.or_else(|| {
            let times = times.iter().find(|times| Some(times.column) == column.time)?;
            wrong_interval(times, cycle_time_ns).map(|text| (text, column.place))
        })
    };
    let wrong: Vec<(&str, String, [usize; 2])> = columns
        .iter()
        .filter_map(|column| interval(column).map(|(text, place)| (column.called(), text, place)))
        .collect();
    if let Some((_, first, place)) = wrong.first() {
        let unsaid = times.iter().find(|times| times.unit(cycle_time_ns).is_none()).map(|times| times.column.name);
        return vec![other_interval(&wrong, first, *place, cycle, unsaid)];
    }
    times.iter().filter_map(|times| gaps(times, cycle_time_ns)).collect()
}

/// The interval of a column of times, if it is not the cycle.
fn wrong_interval(times: &Instants<'_>, cycle_time_ns: u32) -> Option<String> {
    let step = times.step().filter(|_| times.text.is_none())?;
    let Some(unit) = times.unit(cycle_time_ns) else {
        #[expect(clippy::cast_precision_loss, reason = "for a message")]
        let step = step as f64 / 1e9;
        return Some(format!("{step} (`{}` has no unit)", times.column.name.escape_default()));
    };
    let found = nanoseconds(step, unit);
    (!is_near(found, f64::from(cycle_time_ns))).then(|| format!("{} ms", found / 1e6))
}

/// The message about columns of other intervals; `unsaid` are times without a unit.
fn other_interval(
    wrong: &[(&str, String, [usize; 2])],
    first: &str,
    place: [usize; 2],
    cycle: f64,
    unsaid: Option<&str>,
) -> Mistake {
    let same = wrong.iter().all(|(_, interval, _)| interval == first);
    let found = if same {
        format!("a sample every {first} of {}", listed(wrong.iter().map(|(name, ..)| *name)))
    } else {
        let each = wrong.iter().map(|(name, interval, _)| format!("every {interval} of {name}"));
        format!("samples {}", each.collect::<Vec<_>>().join(", "))
    };
    Mistake::new(place, format!("{found}; the block runs every {cycle} ms"), "a sample of every cycle of the block")
        .coded(codes::OTHER_INTERVAL)
        .instead(match unsaid {
            Some(times) => {
                format!("state the unit of the times, as in `time [us]`, or leave them out:{}", option(times))
            }
            None => format!(
                "record these columns every {cycle} ms, or leave them out:{}",
                wrong.iter().map(|(name, ..)| option(name)).collect::<String>()
            ),
        })
}

/// The option that leaves a column out, quoted for a shell.
fn option(name: &str) -> String {
    let is_plain = name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"._-".contains(&byte));
    if is_plain { format!(" --map {name}=-") } else { format!(" --map \"{name}=-\"") }
}

/// The places where a column of times does not increase by one cycle.
fn gaps(times: &Instants<'_>, cycle_time_ns: u32) -> Option<Mistake> {
    const MOST: usize = 5;
    let unit = times.unit(cycle_time_ns).filter(|_| times.text.is_none())?;
    let cycle = f64::from(cycle_time_ns) * 1e9 / nanoseconds(1_000_000_000, unit);
    let (mut lost, mut places, mut repeated) = (0.0, Vec::new(), 0);
    for (cycles, line) in times.cycles(cycle).zip(&times.lines[1..]) {
        if cycles > 1.0 {
            lost += cycles - 1.0;
            places.push(*line);
        } else if cycles < 1.0 {
            repeated += 1;
            places.push(*line);
        }
    }
    let Some(first) = places.first().copied() else { return uneven(times) };
    let shown: Vec<String> = places.iter().take(MOST).map(usize::to_string).collect();
    let more = if places.len() > MOST { ", ..." } else { "" };
    let found = match (lost > 0.0, repeated > 0) {
        (true, false) => format!("{lost} samples are missing"),
        (false, _) => "the time does not go on".to_owned(),
        (true, true) => format!("{lost} samples are missing, and the time does not always go on"),
    };
    let found = format!("{found}: before line {}{more}", shown.join(", "));
    Some(
        Mistake::new([first, 1], found, "one sample in every cycle of the block, in their order")
            .coded(codes::SAMPLES_LOST)
            .instead(
                "record again with fewer channels or a larger buffer, or cut the file before the first of these lines",
            ),
    )
}

/// Steps of almost a cycle each, that together are not as many cycles.
fn uneven(times: &Instants<'_>) -> Option<Mistake> {
    let (drift, line) = times.drift().filter(|(drift, _)| *drift >= 1.0)?;
    let found = format!("the interval changes: a time is {drift:.1} cycles away from even sampling");
    let mistake = Mistake::new([line, 1], found, "a sample of every cycle of the block").coded(codes::OTHER_INTERVAL);
    Some(mistake.instead("record all columns in the task of the block"))
}

/// The number of cycles by which a column begins before the latest one.
pub(crate) fn cycles_between(
    column: &Column<'_>,
    first: i128,
    latest: i128,
    cycle_time_ns: u32,
) -> Result<usize, Mistake> {
    let cycle = i128::from(cycle_time_ns);
    let cycles = (latest - first + cycle / 2) / cycle;
    let rest = (latest - first - cycles * cycle).abs();
    if 4 * rest > cycle {
        #[expect(clippy::cast_precision_loss, reason = "for a message")]
        let apart = rest as f64 / 1e6;
        let found =
            format!("the column `{}` was sampled {apart} ms apart from the others", column.called().escape_default());
        return Err(Mistake::new(column.place, found, "columns that were sampled in the same cycles")
            .coded(codes::OTHER_INTERVAL)
            .instead("record all columns in the task of the block"));
    }
    Ok(usize::try_from(cycles).unwrap_or(usize::MAX))
}
