//! The command `measure`: recordings of an axis, their verdicts as messages, and what was measured as data.

use crate::samples::checked;
use generator::diagnostics::{Diagnostic, Place, Report};
use golden::measure::{self, Channel, Excitation, Excited, Measured, Offset, Verdict, Vibration, When, text};
use golden::signals::{self, Map};
use golden::table::Table;
use serde::Serialize;
use std::fmt::Display;
use std::slice;

/// The options for reading recordings.
pub struct Reading<'a> {
    pub map: &'a Map,
    /// the interval of rows without times [s]
    pub cycle_time: Option<f64>,
    /// sequence of the excited recording; `None` if not stated
    pub excitation: Option<Excitation>,
}

/// A file of a recorder.
#[derive(Clone, Debug)]
pub struct Recorded {
    /// its name in messages
    pub name: String,
    pub text: String,
}

/// A recording, and optionally a second one with an excitation, each with its name in messages.
pub struct Recordings {
    pub own: (String, Measured),
    pub excited: Option<(String, Measured)>,
}

impl Recordings {
    /// Measures both. Without a second recording the stated excitation is that of the first one.
    ///
    /// # Errors
    /// The mistakes of a file.
    pub fn read(own: Recorded, excited: Option<Recorded>, of: &Reading<'_>) -> Result<Self, Report> {
        let stated = of.excitation.unwrap_or(Excitation::Stated { bits: None, clock: None });
        let excited = excited.map(|file| Ok::<_, Report>((measured(&file, of, true, stated, None)?, file.name)));
        let excited = excited.transpose()?.map(|(measured, name)| (name, measured));
        let (of_own, other) = match &excited {
            Some((_, other)) => (Excitation::AsRecorded, Some(other)),
            None => (of.excitation.unwrap_or(Excitation::AsRecorded), None),
        };
        let of_own = measured(&own, of, other.is_some(), of_own, other)?;
        Ok(Self { own: (own.name, of_own), excited })
    }

    /// The second recording, if there is one.
    #[must_use]
    pub fn second(&self) -> Option<&Measured> {
        self.excited.as_ref().map(|(_, measured)| measured)
    }

    /// Both, each with its name in messages.
    pub fn all(&self) -> impl Iterator<Item = &(String, Measured)> {
        std::iter::once(&self.own).chain(&self.excited)
    }

    /// Both.
    pub fn measured(&self) -> impl Iterator<Item = &Measured> {
        self.all().map(|(_, measured)| measured)
    }

    #[must_use]
    pub fn response(&self) -> Option<&Excited> {
        self.measured().find_map(|measured| measured.excited.as_ref())
    }

    /// The verdicts as messages about the recordings: an error, if a measurement is impossible.
    pub fn said(&self) -> Report {
        let mut report = Report::default();
        self.all().for_each(|(file, measured)| say(&mut report, file, &measured.verdicts));
        report
    }
}

/// Reads a recording and measures it. If there are two, a name in the map may be a column of the other one.
fn measured(
    file: &Recorded,
    of: &Reading<'_>,
    are_two: bool,
    excitation: Excitation,
    other: Option<&Measured>,
) -> Result<Measured, Report> {
    let wanted: Vec<&str> = of.map.iter().map(|(name, _)| name.as_str()).collect();
    let table = Table::read(&file.text, &wanted).without(of.map);
    let unknown = if are_two { Vec::new() } else { signals::unknown(of.map, slice::from_ref(&&table)) };
    let channels = checked(measure::read(&table, of.map), &unknown, &file.name)?;
    Ok(measure::measure(channels, of.cycle_time, excitation, other))
}

/// Verdicts about a file, or about an axis.
pub fn say(report: &mut Report, of: impl Display, verdicts: &[Verdict]) {
    for verdict in verdicts {
        let said = if verdict.refuses { Diagnostic::error } else { Diagnostic::warning };
        report.push(said(verdict.code, Place::whole(&of), verdict.found.clone()).instead(verdict.instead.clone()));
    }
}

/// A verdict for machines.
#[derive(Clone, Debug, Serialize)]
pub struct Said {
    pub code: &'static str,
    pub text: String,
}

impl From<&Verdict> for Said {
    fn from(Verdict { code, found, instead, .. }: &Verdict) -> Self {
        Self { code, text: format!("{found}; {instead}") }
    }
}

/// What was measured: `null` is what is not known.
#[derive(Clone, Debug, Serialize)]
pub struct Results {
    pub channels: Vec<ChannelRow>,
    pub segments: Vec<SegmentRow>,
    pub dead_time_s: Option<f64>,
    pub dead_time_error_s: Option<f64>,
    pub offsets: Vec<OffsetRow>,
    pub vibrations: Vec<VibrationRow>,
    pub response: Option<Response>,
    pub verdicts: Vec<Said>,
}

#[derive(Clone, Debug, Serialize)]
pub struct ChannelRow {
    pub name: &'static str,
    pub interval_s: Option<f64>,
    pub jitter_s: f64,
    pub missing: usize,
    pub unit: Option<&'static str>,
}

/// A segment of the command, in samples.
#[derive(Clone, Debug, Serialize)]
pub struct SegmentRow {
    pub kind: &'static str,
    pub from: usize,
    pub to: usize,
}

/// How much later a channel is than another one.
#[derive(Clone, Debug, Serialize)]
pub struct OffsetRow {
    pub of: &'static str,
    pub to: &'static str,
    pub s: Option<f64>,
    pub error_s: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
pub struct VibrationRow {
    pub channel: &'static str,
    pub hz: f64,
    pub hz_error: f64,
    pub damping: Option<f64>,
    pub damping_error: Option<f64>,
    pub amplitude: f64,
    pub when: &'static str,
    pub forced: bool,
    pub competes: bool,
    pub edge: bool,
    pub order: Option<f64>,
    pub source: Option<&'static str>,
}

/// The response of the drive: lines by frequency, with their standard errors.
#[derive(Clone, Debug, Serialize)]
pub struct Response {
    pub hz: Vec<f64>,
    pub re: Vec<f64>,
    pub im: Vec<f64>,
    pub se: Vec<f64>,
}

/// The results of both recordings. Channels and segments are those of the first one.
#[must_use]
pub fn results(all: &Recordings) -> Results {
    let own = &all.own.1;
    let dead_time = all.response().and_then(|excited| excited.dead_time);
    let segment = |of: &identification::segments::Segment| SegmentRow {
        kind: text::word(of.kind),
        from: of.samples.start,
        to: of.samples.end,
    };
    Results {
        channels: own.channels.iter().map(channel).collect(),
        segments: own.segments.iter().map(segment).collect(),
        dead_time_s: dead_time.map(|time| time.seconds),
        dead_time_error_s: dead_time.map(|time| time.error),
        offsets: all.measured().flat_map(|measured| &measured.offsets).map(offset).collect(),
        vibrations: all.measured().flat_map(|measured| &measured.vibrations).map(vibration).collect(),
        response: all.response().map(response),
        verdicts: all.measured().flat_map(|measured| &measured.verdicts).map(Said::from).collect(),
    }
}

fn channel(of: &Channel) -> ChannelRow {
    let (timing, unit) = (&of.timing, of.unit.map(|unit| unit.name));
    let (interval_s, jitter_s, missing) = (timing.interval, timing.jitter, timing.missing);
    ChannelRow { name: of.signal, interval_s, jitter_s, missing, unit }
}

fn offset(of: &Offset) -> OffsetRow {
    OffsetRow { of: of.of, to: of.to, s: of.time.map(|time| time.seconds), error_s: of.time.map(|time| time.error) }
}

fn vibration(of: &Vibration) -> VibrationRow {
    VibrationRow {
        channel: of.channel,
        hz: of.hz,
        hz_error: of.hz_error,
        damping: of.damping.map(|[damping, _]| damping),
        damping_error: of.damping.map(|[_, error]| error),
        amplitude: of.amplitude,
        when: match of.when {
            When::Driving => "driving",
            When::Ramps => "ramps",
            When::Excited => "excited",
        },
        forced: of.is_forced,
        competes: of.competes,
        edge: of.is_at_edge,
        order: of.order,
        source: of.source.map(text::side_word),
    }
}

fn response(of: &Excited) -> Response {
    let lines = &of.lines;
    Response {
        hz: lines.hz.clone(),
        re: lines.response.iter().map(|p| p.re).collect(),
        im: lines.response.iter().map(|p| p.im).collect(),
        se: lines.error.clone(),
    }
}
