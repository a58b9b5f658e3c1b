//! `axgen measure`: the properties of an axis in a recording, as a report, as JSON, as a picture, and its response as CSV.

use crate::arguments::MeasureArguments;
use crate::exit::Exit;
use crate::given::{self, name_of};
use crate::messages::{self, Format};
use crate::one_file::{self, Rule};
use crate::output;
use crate::times;
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use golden::measure::{self, Excitation, Excited, Measured, Verdict, Vibration, When, picture, text};
use golden::signals::{self, Map};
use golden::svg;
use golden::table::Table;
use serde_json::{Value, json};
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// Bits of a sequence, and the longest clock [cycles].
const BITS: std::ops::RangeInclusive<u32> = 7..=15;
const LONGEST_CLOCK: u32 = 1000;
/// Limits of an interval [s].
const INTERVALS: std::ops::RangeInclusive<f64> = 1e-6..=0.1;

/// A sequence of `--excitation`: `11`, `11x2`, `default`.
pub fn excitation(text: &str) -> Result<Excitation, String> {
    let allowed =
        || "BITS or BITSxCLOCK is allowed, 7 to 15 bits and a clock of 1 to 1000 cycles: 11x2; or default".to_owned();
    if text == "default" {
        return Ok(Excitation::Stated { bits: None, clock: None });
    }
    let (bits, clock) = text.split_once('x').map_or((text, None), |(bits, clock)| (bits, Some(clock)));
    let bits = bits.parse().ok().filter(|bits| BITS.contains(bits)).ok_or_else(allowed)?;
    let is_clock = |clock: &u32| (1..=LONGEST_CLOCK).contains(clock);
    let clock = clock.map(|clock| clock.parse().ok().filter(is_clock).ok_or_else(allowed)).transpose()?;
    Ok(Excitation::Stated { bits: Some(bits), clock })
}

/// A time of `--cycle-time`: `1ms`, `62.5us`.
pub fn interval(text: &str) -> Result<f64, String> {
    const UNITS: [(&str, f64); 4] = [("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9), ("s", 1.0)];
    let time = times::seconds(text, &UNITS).filter(|time| INTERVALS.contains(time));
    time.ok_or_else(|| "a time from 1us to 100ms is allowed: 1ms, 62.5us".to_owned())
}

/// The options for reading recordings.
pub struct Reading<'a> {
    pub map: &'a Map,
    /// the interval of rows without times [s]
    pub cycle_time: Option<f64>,
    /// sequence of the excited recording; `None` if not stated
    pub excitation: Option<Excitation>,
}

/// A recording, and optionally a second one with an excitation.
pub struct Recordings<'a> {
    pub own: (&'a Path, Measured),
    pub excited: Option<(&'a Path, Measured)>,
}

impl<'a> Recordings<'a> {
    /// Reads and measures both. Without a second recording the stated excitation is that of the first one.
    pub fn read(own: &'a Path, excited: Option<&'a Path>, of: &Reading<'_>) -> Result<Self, Exit> {
        let stated = of.excitation.unwrap_or(Excitation::Stated { bits: None, clock: None });
        let excited = excited.map(|file| Ok((file, measured(file, of, true, stated, None)?))).transpose()?;
        let (of_own, other) = match &excited {
            Some((_, other)) => (Excitation::AsRecorded, Some(other)),
            None => (of.excitation.unwrap_or(Excitation::AsRecorded), None),
        };
        Ok(Self { own: (own, measured(own, of, other.is_some(), of_own, other)?), excited })
    }

    /// The second recording, if there is one.
    pub fn second(&self) -> Option<&Measured> {
        self.excited.as_ref().map(|(_, measured)| measured)
    }

    pub fn all(&self) -> impl Iterator<Item = &(&'a Path, Measured)> {
        std::iter::once(&self.own).chain(&self.excited)
    }

    /// The verdicts as messages about the recordings: an error, if a measurement is impossible.
    pub fn said(&self) -> Report {
        let mut report = Report::default();
        self.all().for_each(|(file, measured)| say(&mut report, name_of(file), &measured.verdicts));
        report
    }

    fn measured(&self) -> impl Iterator<Item = &Measured> {
        self.all().map(|(_, measured)| measured)
    }

    fn response(&self) -> Option<&Excited> {
        self.measured().find_map(|measured| measured.excited.as_ref())
    }
}

/// Runs the command.
pub fn run(of: &MeasureArguments, format: Format) -> Result<Exit, Exit> {
    let recording = of.recording.as_path();
    let is_response = |found: &[u8]| found.starts_with(text::HEAD.as_bytes());
    let is_picture = |found: &[u8]| found.starts_with(svg::HEAD.as_bytes());
    let rules = [Rule::earlier_output(of.force, &is_response), Rule::earlier_output(of.force, &is_picture)];
    one_file::told_apart(&of.response.iter().chain(&of.picture).map(PathBuf::as_path).collect::<Vec<_>>())?;
    for (out, rule) in [of.response.as_deref(), of.picture.as_deref()].into_iter().zip(rules) {
        let Some(out) = out else { continue };
        one_file::kept_apart(out, [Some(recording), of.excited.as_deref()].into_iter().flatten())?;
        rule.allows(out)?;
    }
    let reading = Reading { map: &of.map, cycle_time: of.cycle_time, excitation: of.excitation };
    let all = Recordings::read(recording, of.excited.as_deref(), &reading)?;
    write(&all, of, rules)?;
    if of.json {
        output::line(format!("{:#}", as_json(&all)))?;
    } else {
        for measured in all.measured() {
            output::print(text::report(measured))?;
        }
        output::say(&messages::text(&all.said(), format));
    }
    Ok(if all.measured().any(Measured::refuses) { Exit::Different } else { Exit::Done })
}

/// Reads a recording and measures it. If there are two, a name in the map may be a column of the other one.
fn measured(
    file: &Path,
    of: &Reading<'_>,
    are_two: bool,
    excitation: Excitation,
    other: Option<&Measured>,
) -> Result<Measured, Exit> {
    let text = given::text(file)?;
    let wanted: Vec<&str> = of.map.iter().map(|(name, _)| name.as_str()).collect();
    let table = Table::read(&text, &wanted).without(of.map);
    let unknown = if are_two { Vec::new() } else { signals::unknown(of.map, &[&table]) };
    let channels = given::checked(measure::read(&table, of.map), &unknown, file)?;
    Ok(measure::measure(channels, of.cycle_time, excitation, other))
}

/// Writes the files that were asked for, all or none.
fn write(all: &Recordings<'_>, of: &MeasureArguments, [of_response, of_picture]: [Rule<'_>; 2]) -> Result<(), Exit> {
    let response = match (of.response.as_deref(), all.response()) {
        (Some(path), Some(excited)) => Some(one_file::stage(path, text::response(excited).as_bytes(), of_response)?),
        (Some(_), None) if !all.measured().any(Measured::refuses) => {
            let found = "the recording has no excitation: record v_excite, or give --excitation or --excited";
            return Err(Exit::input(codes::USAGE, "--response", found));
        }
        _ => None,
    };
    let drawn = of.picture.as_deref().zip(picture::svg(&all.own.1, all.response()));
    let picture = drawn.map(|(path, picture)| one_file::stage(path, picture.as_bytes(), of_picture)).transpose()?;
    one_file::commit([response, picture].into_iter().flatten())
}

/// Verdicts about a file, or about an axis.
pub fn say(report: &mut Report, of: impl Display, verdicts: &[Verdict]) {
    for verdict in verdicts {
        let said = if verdict.refuses { Diagnostic::error } else { Diagnostic::warning };
        report.push(said(verdict.code, Place::whole(&of), verdict.found.clone()).instead(verdict.instead));
    }
}

/// Verdicts as JSON.
pub fn verdicts_json<'v>(verdicts: impl Iterator<Item = &'v Verdict>) -> Vec<Value> {
    let text = |verdict: &Verdict| format!("{}; {}", verdict.found, verdict.instead);
    verdicts.map(|verdict| json!({ "code": verdict.code, "text": text(verdict) })).collect()
}

fn as_json(all: &Recordings<'_>) -> Value {
    let each = || all.measured();
    let own = &all.own.1;
    let channels: Vec<Value> = (own.channels.iter())
        .map(|channel| {
            json!({
                "name": channel.signal,
                "interval_s": channel.timing.interval,
                "jitter_s": channel.timing.jitter,
                "missing": channel.timing.missing,
                "unit": channel.unit.map(|unit| unit.name),
            })
        })
        .collect();
    let offsets = each().flat_map(|measured| &measured.offsets).map(|offset| {
        let time = offset.time;
        json!({ "of": offset.of, "to": offset.to, "s": time.map(|time| time.seconds), "error_s": time.map(|time| time.error) })
    });
    let segments = own.segments.iter().map(
        |segment| json!({ "kind": text::word(segment.kind), "from": segment.samples.start, "to": segment.samples.end }),
    );
    let dead_time = all.response().and_then(|excited| excited.dead_time);
    json!({
        "channels": channels,
        "segments": segments.collect::<Vec<_>>(),
        "dead_time_s": dead_time.map(|time| time.seconds),
        "dead_time_error_s": dead_time.map(|time| time.error),
        "offsets": offsets.collect::<Vec<_>>(),
        "vibrations": each().flat_map(|measured| &measured.vibrations).map(vibration_json).collect::<Vec<_>>(),
        "response": all.response().map(response_json),
        "verdicts": verdicts_json(each().flat_map(|measured| &measured.verdicts)),
    })
}

fn vibration_json(vibration: &Vibration) -> Value {
    let when = match vibration.when {
        When::Driving => "driving",
        When::Ramps => "ramps",
        When::Excited => "excited",
    };
    json!({
        "channel": vibration.channel,
        "hz": vibration.hz,
        "hz_error": vibration.hz_error,
        "damping": vibration.damping.map(|[damping, _]| damping),
        "damping_error": vibration.damping.map(|[_, error]| error),
        "amplitude": vibration.amplitude,
        "when": when,
        "forced": vibration.is_forced,
        "competes": vibration.competes,
        "edge": vibration.is_at_edge,
        "order": vibration.order,
        "source": vibration.source.map(text::side_word),
    })
}

fn response_json(excited: &Excited) -> Value {
    let lines = &excited.lines;
    json!({
        "hz": lines.hz,
        "re": lines.response.iter().map(|p| p.re).collect::<Vec<_>>(),
        "im": lines.response.iter().map(|p| p.im).collect::<Vec<_>>(),
        "se": lines.error,
    })
}
