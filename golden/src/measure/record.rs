//! Channels as samples with common times, and derived signals: the command, the following error, segments. No spectrum.

use super::channels::{Channel, Timing};
use super::unit::{Quantity, Unit, is_near};
use super::verdict::Verdict;
use generator::codes;
use portable::{Extreme, peak};
use std::borrow::Cow;

/// The signals of sensors.
const SENSORS: [&str; 3] = ["v_motor", "v_direct", "a_load"];
/// Times over which the command is smoothed twice [s]: for a planned position because of its digits, for a controller's
/// output because of the vibration that it feeds back.
const OF_POSITION: f64 = 0.01;
pub(super) const OF_VELOCITY: f64 = 0.1;
/// Tolerances: for equal intervals, relative; for simultaneous samples and for jitter, relative to an interval.
const SAME_INTERVAL: f64 = 1e-3;
const TOGETHER: f64 = 0.25;
/// The axis moves if the command exceeds this multiple of the rms value that smoothing removes from it.
const MOVES: f64 = 3.0;
/// A clipped channel stays at its largest value for this number of samples, this number of times, after a change of this
/// part of its range in one sample.
const CLIPPED: (usize, usize, f64) = (3, 2, 0.01);

/// A value is a whole number of steps of its last digit within that part; the largest number of decimal places.
const WHOLE: f64 = 1e-3;
const MOST_DIGITS: u32 = 16;

/// A sample is wrong if it is more than this multiple of all others.
const OUTLIER: f64 = 10.0;

/// All channels with one interval, from the latest first sample to the earliest last one.
#[derive(Clone, Debug)]
pub struct Record {
    /// T [s]
    pub cycle: f64,
    channels: Vec<Channel>,
}

impl Record {
    /// Combines channels without gaps. The verdicts are about channels that are left out.
    pub(super) fn new(mut channels: Vec<Channel>, verdicts: &mut Vec<Verdict>) -> Option<Self> {
        let of = |names: &[&str]| channels.iter().find(|channel| names.contains(&channel.signal));
        let cycle = of(&["v_motor"]).or(channels.first())?.timing.interval?;
        let is_as_often = |timing: &Timing| timing.interval.is_some_and(|interval| is_same(interval, cycle));
        let (latest, mut apart) = (channels.iter().filter_map(|channel| channel.timing.begins).max(), Vec::new());
        let jitters = channels.iter().any(|channel| channel.timing.jitter > TOGETHER * cycle);
        for channel in &mut channels {
            let begins = channel.timing.begins.or(latest);
            #[expect(clippy::cast_precision_loss, reason = "the time between two channels of one file")]
            let late = latest.zip(begins).map_or(0.0, |(latest, begins)| (latest - begins) as f64 / 1e9 / cycle);
            let is_even = channel.timing.jitter <= TOGETHER * cycle;
            if !is_as_often(&channel.timing) || libm::fabs(late - libm::round(late)) > TOGETHER || !is_even {
                let line = channel.timing.uneven.filter(|_| !is_even);
                let line = line.map_or_else(String::new, |line| format!(", unevenly at line {line}"));
                apart.push(format!("{} every {} ms{line}", channel.signal, shown(channel.timing.interval)));
                channel.values.clear();
                continue;
            }
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative, saturates")]
            let first = (libm::round(late) as usize).min(channel.values.len());
            channel.values.drain(..first);
        }
        if !apart.is_empty() {
            let found =
                format!("not sampled evenly, together and every {} ms: {}", shown(Some(cycle)), apart.join(", "));
            let instead = match jitters {
                true => {
                    "record all channels in one task; if only the time stamps jitter, leave them out with --map TIME=- and \
                     give --cycle-time"
                }
                false => "record all channels in one task, or leave these out with --map NAME=-",
            };
            verdicts.push(Verdict::refusal(codes::TWO_RATES, found, instead));
        }
        channels.retain(|channel| !channel.values.is_empty());
        let length = channels.iter().map(|channel| channel.values.len()).min()?;
        channels.iter_mut().for_each(|channel| channel.values.truncate(length));
        Some(Self { cycle, channels })
    }

    pub(super) fn channel(&self, signal: &str) -> Option<&Channel> {
        self.channels.iter().find(|channel| channel.signal == signal)
    }

    /// The samples of a signal.
    #[must_use]
    pub fn get(&self, signal: &str) -> Option<&[f64]> {
        self.channel(signal).map(|channel| channel.values.as_slice())
    }

    /// Samples of each channel.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.channels.first().map_or(0, |channel| channel.values.len())
    }

    /// The command to the drive: `v_cmd`, or the sum of its parts in the unit of `v_command`.
    #[must_use]
    pub fn v_cmd(&self) -> Option<Cow<'_, [f64]>> {
        if let Some(v_cmd) = self.get("v_cmd") {
            return Some(Cow::Borrowed(v_cmd));
        }
        let command = self.channel("v_command")?;
        let mut sum = command.values.clone();
        for part in ["v_add", "v_excite"].into_iter().filter_map(|name| self.channel(name)) {
            let ratio = part.ratio_to(command);
            sum.iter_mut().zip(&part.values).for_each(|(sum, part)| *sum += ratio * part);
        }
        Some(Cow::Owned(sum))
    }

    /// The following error: command minus position of the motor.
    #[must_use]
    pub fn following_error(&self) -> Option<Cow<'_, [f64]>> {
        let difference = || {
            let (command, actual) = self.get("x_command").zip(self.get("x_actual"))?;
            Some(Cow::Owned(command.iter().zip(actual).map(|(command, actual)| command - actual).collect()))
        };
        self.get("following_error").map(Cow::Borrowed).or_else(difference)
    }

    /// The step of the last written digit of a signal; the sum of those of its parts for a following error that is their
    /// difference.
    pub(super) fn written(&self, signal: &str) -> f64 {
        let parts: &[&str] = match self.get(signal) {
            None if signal == "following_error" => &["x_command", "x_actual"],
            _ => &[signal],
        };
        parts.iter().filter_map(|part| self.get(part)).map(last_digit).sum()
    }

    /// The acceleration of the load, from the sensor nearest to the tool; `None` if the load has no sensor.
    #[must_use]
    pub fn load(&self) -> Option<Cow<'_, [f64]>> {
        let derived = || Some(Cow::Owned(rate(self.get("v_direct")?, self.cycle)));
        self.get("a_load").map(Cow::Borrowed).or_else(derived)
    }

    /// The unit of a signal, or of the following error, which may be that of its parts.
    #[must_use]
    pub fn unit(&self, signal: &str) -> Option<Unit> {
        let known = self.channel(signal).and_then(|channel| channel.unit);
        known.or_else(|| self.channel("x_command").filter(|_| signal == "following_error")?.unit)
    }

    /// The unit of the following error divided by the distance that `v_motor` covers in 1 s with the value 1; `None` if one of
    /// the units is unknown.
    #[must_use]
    pub fn error_unit(&self) -> Option<f64> {
        Some(self.unit("following_error")?.size / self.unit("v_motor")?.size)
    }

    /// The unit of the command, as a velocity.
    #[must_use]
    pub fn command_unit(&self) -> Option<String> {
        match self.channel("x_command") {
            Some(x) => x.unit.map(|unit| format!("{}/s", unit.name)),
            None => ["v_command", "v_cmd"].iter().find_map(|name| self.unit(name)).map(|unit| unit.name.to_owned()),
        }
    }

    /// The commanded velocity, smoothed, in the unit of its channel (for a position per s); and whether it moves the axis.
    pub(super) fn command(&self) -> Option<(Vec<f64>, bool)> {
        let (raw, time) = match self.get("x_command") {
            Some(x) => (rate(x, self.cycle), OF_POSITION),
            None => (["v_command", "v_cmd"].iter().find_map(|name| self.get(name))?.to_vec(), OF_VELOCITY),
        };
        let smooth = smoothed(&smoothed(&raw, time / self.cycle), time / self.cycle);
        let rest: f64 = raw.iter().zip(&smooth).map(|(raw, smooth)| (raw - smooth) * (raw - smooth)).sum();
        let moves = peak(&smooth) > MOVES * (rest / raw.len() as f64).sqrt();
        Some((smooth, moves))
    }

    /// Infers the units that the columns do not state, and reports contradictions; returns whether a response between both
    /// velocities is possible.
    pub(super) fn find_units(&mut self, verdicts: &mut Vec<Verdict>) -> bool {
        self.infer_units();
        self.find_assumed_units(verdicts);
        self.velocities_fit(verdicts)
    }

    fn infer_units(&mut self) {
        let velocity = ["v_motor", "v_cmd", "v_command"].into_iter().find_map(|name| self.channel(name));
        let of_velocity = velocity.and_then(|of| of.unit.or_else(|| Unit::of_velocity(peak(&of.values))));
        let speed = velocity.map(|of| of.values.clone());
        let cycle = self.cycle;
        let is_rotary = self.channels.iter().any(|channel| channel.unit.is_some_and(Unit::is_rotary));
        for channel in self.channels.iter_mut().filter(|channel| channel.unit.is_none()) {
            let largest = peak(&channel.values);
            channel.unit = match (channel.quantity, channel.signal) {
                (Quantity::Velocity, "v_add" | "v_add_calculated" | "v_excite") => of_velocity,
                (Quantity::Velocity, _) => Unit::of_velocity(largest),
                (Quantity::Position, "following_error") => Unit::of_error(largest),
                (Quantity::Position, _) => of_velocity
                    .zip(speed.as_deref())
                    .and_then(|(unit, speed)| Unit::of_position(slope(speed, &rate(&channel.values, cycle))?, unit)),
                (Quantity::Acceleration, _) => Unit::of_acceleration(largest),
            };
            // A sensor at the load of a rotary axis measures along its path all the same.
            if is_rotary && channel.quantity != Quantity::Acceleration {
                channel.unit = channel.unit.map(|unit| unit.rotary().unwrap_or(unit));
            }
        }
    }

    fn find_assumed_units(&self, verdicts: &mut Vec<Verdict>) {
        for Channel { signal, unit, scaling, .. } in self.channels.iter().filter(|channel| channel.is_stated) {
            let Some((scaling, unit)) = scaling.as_ref().zip(*unit) else { continue };
            let found = format!("{signal} has {scaling}: its values are taken as scaled, in {}", unit.name);
            let instead = "check that the export scales the values; if not, export them again, scaled";
            verdicts.push(Verdict::note(codes::ASSUMED_UNIT, found, instead));
        }
        for Channel { signal, unit, other_unit, quantity, .. } in &self.channels {
            let Some(stated) = other_unit else { continue };
            let taken = unit.map_or("no unit", |unit| unit.name);
            let found = format!("the unit of {signal}, `{stated}`, is not known: {taken} is assumed");
            let instead = format!("state its unit after its name, as in `{signal} [UNIT]`: {}", quantity.names());
            verdicts.push(Verdict::note(codes::ASSUMED_UNIT, found, instead));
        }
    }

    fn velocities_fit(&self, verdicts: &mut Vec<Verdict>) -> bool {
        let Some(motor) = self.channel("v_motor") else { return true };
        let Some(command) = ["v_cmd", "v_command"].into_iter().find_map(|name| self.channel(name)) else { return true };
        let Some(ratio) = slope(&command.values, &motor.values) else { return true };
        let ratio = ratio * self.velocity_ratio();
        let instead = "record both in um/s (rotary axes: 0.001 deg/s) and in the direction of the command";
        let factor = [1e-6, 1e-3, 1e3, 1e6].into_iter().find(|factor| is_near(ratio / factor));
        let found = match factor {
            Some(factor) => format!("v_motor is {factor} times as large as {}", command.signal),
            None if is_near(-ratio) => format!("v_motor has the other sign than {}", command.signal),
            None => return true,
        };
        verdicts.push(Verdict::refusal(codes::UNITS_DIFFER, found, instead));
        false
    }

    /// The unit of `v_motor` divided by that of the command, if both are stated; else 1.
    pub(super) fn velocity_ratio(&self) -> f64 {
        let command = self.channel("v_cmd").or_else(|| self.channel("v_command"));
        self.channel("v_motor").zip(command).map_or(1.0, |(motor, command)| motor.ratio_to(command))
    }

    /// The unit of a signal divided by its unit in another recording; `None` if one of them is unknown, or if they differ and
    /// are not both stated.
    pub(super) fn unit_ratio(&self, other: &Self, signal: &str) -> Option<f64> {
        let (own, other) = self.channel(signal).zip(other.channel(signal))?;
        let units = (own.unit?, other.unit?);
        (own.is_stated && other.is_stated || units.0 == units.1).then(|| units.0.size / units.1.size)
    }

    /// Reports sensors that are at their limit.
    pub(super) fn find_clipping(&self, verdicts: &mut Vec<Verdict>) {
        for name in SENSORS {
            let Some(at) = self.get(name).and_then(clipped) else { continue };
            let found = format!("{name} stays at its largest value, first at {:.3} s", at as f64 * self.cycle);
            verdicts.push(Verdict::note(codes::CLIPPED, found, "choose a larger range of the sensor or the recorder"));
        }
    }

    /// Refuses sensors with a wrong sample: its spectrum hides all lines.
    pub(super) fn find_outliers(&self, verdicts: &mut Vec<Verdict>) {
        for name in SENSORS {
            let Some((at, value)) = self.get(name).and_then(outlier) else { continue };
            let found = format!(
                "one sample of {name} is more than {OUTLIER} times all others: {value} at {:.3} s",
                at as f64 * self.cycle
            );
            verdicts.push(Verdict::refusal(codes::OUTLIER, found, "record again, or correct this sample in the file"));
        }
    }

    /// The same with other samples of each channel, which its place among them and the channel give; without those of none.
    pub(crate) fn with(&self, samples: impl Fn(usize, &Channel) -> Option<Vec<f64>>) -> Self {
        let changed =
            |(k, channel): (usize, &Channel)| Some(Channel { values: samples(k, channel)?, ..channel.clone() });
        Self { cycle: self.cycle, channels: self.channels.iter().enumerate().filter_map(changed).collect() }
    }

    /// Channels with their units, for a report.
    #[must_use]
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }
}

/// Whether two intervals are almost equal.
#[must_use]
pub fn is_same(a: f64, b: f64) -> bool {
    libm::fabs(a / b - 1.0) < SAME_INTERVAL
}

fn shown(interval: Option<f64>) -> String {
    interval.map_or_else(|| "an unknown number of".to_owned(), |interval| (interval * 1e3).to_string())
}

/// The sample that is more than a multiple of all others, and its value.
fn outlier(values: &[f64]) -> Option<(usize, f64)> {
    let (mut largest, mut second) = ((0, 0.0), 0.0);
    for (at, value) in values.iter().copied().enumerate() {
        if libm::fabs(value) > libm::fabs(largest.1) {
            (largest, second) = ((at, value), libm::fabs(largest.1));
        } else {
            second = libm::fabs(value).larger(second);
        }
    }
    (libm::fabs(largest.1) > OUTLIER * second).then_some(largest)
}

/// The sample in which a signal first stays at an end of its range, if it does so suddenly and repeatedly.
fn clipped(values: &[f64]) -> Option<usize> {
    let (length, often, sudden) = CLIPPED;
    let low = values.iter().copied().fold(f64::INFINITY, f64::smaller);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::larger);
    for end in [low, high] {
        let is_run = |n: &usize| {
            let stays = values[*n..n + length].iter().all(|value| value.to_bits() == end.to_bits());
            let comes = libm::fabs(values[n - 1] - values[n - 2]) > sudden * (high - low);
            stays && values[n - 1].to_bits() != end.to_bits() && comes
        };
        let mut runs = (2..values.len().saturating_sub(length)).filter(is_run);
        let first = runs.next();
        if runs.count() + 1 >= often && first.is_some() {
            return first;
        }
    }
    None
}

/// The change per second.
pub(super) fn rate(x: &[f64], cycle: f64) -> Vec<f64> {
    std::iter::once(0.0).chain(x.windows(2).map(|pair| (pair[1] - pair[0]) / cycle)).collect()
}

/// The step of the last digit of the values from half of the peak on: smaller ones may have more digits.
fn last_digit(values: &[f64]) -> f64 {
    let least = peak(values) / 2.0;
    let is_whole = |value: f64| libm::fabs(value - libm::round(value)) < WHOLE;
    let mut digits = (0..MOST_DIGITS).map(|digits| libm::exp10(f64::from(digits)));
    let is_written = |scale: &f64| values.iter().filter(|v| libm::fabs(**v) >= least).all(|v| is_whole(v * scale));
    digits.find(is_written).map_or(0.0, |scale| 1.0 / scale)
}

/// The least squares factor from x to y; `None` if x is 0.
fn slope(x: &[f64], y: &[f64]) -> Option<f64> {
    let (xy, xx) = x.iter().zip(y).fold((0.0, 0.0), |(xy, xx), (x, y)| (xy + x * y, xx + x * x));
    (xx > 0.0).then(|| xy / xx)
}

/// Moving averages over this number of samples, centred.
pub(super) fn smoothed(values: &[f64], samples: f64) -> Vec<f64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundred samples")]
    let half = (libm::round(samples / 2.0)) as usize;
    let mut sums = vec![0.0];
    for value in values {
        sums.push(sums[sums.len() - 1] + value);
    }
    let mean = |n: usize| {
        let (from, to) = (n.saturating_sub(half), (n + half + 1).min(values.len()));
        (sums[to] - sums[from]) / (to - from) as f64
    };
    (0..values.len()).map(mean).collect()
}
