//! `axgen measure`: the properties of an axis in a recording, as a report, as JSON, as a picture, and its response as CSV.

use crate::arguments::MeasureArguments;
use crate::exit::Exit;
use crate::given::{self, name_of};
use crate::messages::{self, Format};
use crate::one_file::{self, Rule};
use crate::output;
use commands::json;
use commands::measure::{self, Reading, Recorded, Recordings};
use commands::words::{TIMES, seconds};
use generator::codes;
use golden::measure::{Excitation, Measured, is_same_interval, picture, text};
use std::path::Path;

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
    let time = seconds(text, &TIMES).filter(|time| INTERVALS.contains(time));
    time.ok_or_else(|| "a time from 1us to 100ms is allowed: 1ms, 62.5us".to_owned())
}

/// Runs the command.
pub fn run(of: &MeasureArguments, format: Format) -> Result<Exit, Exit> {
    let recording = of.recording.as_path();
    let is_response = |found: &[u8]| found.starts_with(text::HEAD.as_bytes());
    let rules = [Rule::earlier_output(of.force, &is_response), Rule::earlier_picture(of.force)];
    let outs = [of.response.as_deref(), of.picture.as_deref()].into_iter().zip(rules);
    one_file::allowed(outs, [Some(recording), of.excited.as_deref()].into_iter().flatten())?;
    let reading = Reading { map: &of.map, cycle_time: of.cycle_time, excitation: of.excitation };
    let all = read(recording, of.excited.as_deref(), &reading)?;
    agrees(&all, of.cycle_time)?;
    write(&all, of, rules)?;
    if of.json {
        output::line(json::text(&measure::results(&all)))?;
    } else {
        for measured in all.measured() {
            output::print(text::report(measured))?;
        }
        output::say(&messages::text(&all.said(), format));
    }
    Ok(if all.measured().any(Measured::refuses) { Exit::Different } else { Exit::Done })
}

/// Refuses a `--cycle-time` that contradicts the times of a recording.
fn agrees(all: &Recordings, cycle_time: Option<f64>) -> Result<(), Exit> {
    let Some(stated) = cycle_time else { return Ok(()) };
    let mut intervals = all.measured().flat_map(|of| &of.channels).filter_map(|channel| channel.timing.interval);
    let is_other = |interval: &f64| !is_same_interval(*interval, stated);
    intervals.find(is_other).map_or(Ok(()), |interval| {
        let [stated, interval] = [stated, interval].map(|seconds| seconds * 1e3);
        let said =
            format!("{stated} ms contradicts the times of the recording, every {interval} ms: leave one of them out");
        Err(Exit::input(codes::USAGE, "--cycle-time", said))
    })
}

/// Reads and measures a recording, and optionally a second one.
pub fn read(own: &Path, excited: Option<&Path>, of: &Reading<'_>) -> Result<Recordings, Exit> {
    let recorded = |file: &Path| Ok::<_, Exit>(Recorded { name: name_of(file), text: given::text(file)? });
    let excited = excited.map(recorded).transpose()?;
    Ok(Recordings::read(recorded(own)?, excited, of)?)
}

/// Writes the files that were asked for, all or none.
fn write(all: &Recordings, of: &MeasureArguments, [of_response, of_picture]: [Rule<'_>; 2]) -> Result<(), Exit> {
    let response = match (of.response.as_deref(), all.response()) {
        (Some(path), Some(excited)) => Some(one_file::stage(path, text::response(excited).as_bytes(), of_response)?),
        (Some(_), None) if !all.measured().any(Measured::refuses) => {
            let found = "the recording has no excitation: record v_excite, or give --excitation or --excited";
            return Err(Exit::input(codes::USAGE, "--response", found));
        }
        _ => None,
    };
    let drawn = of.picture.as_deref().zip(picture::of(&all.own.1, all.response()));
    let picture =
        drawn.map(|(path, picture)| one_file::stage(path, picture.svg().as_bytes(), of_picture)).transpose()?;
    one_file::commit([response, picture].into_iter().flatten())
}
