//! `axgen simulate`: the block of an axis in a closed loop, off against on, as a table, as CSV and as a picture.

use crate::arguments::SimulateArguments;
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::one_file::{self, Rule, Staged};
use crate::output;
use commands::words::{made, seconds};
use generator::blocks::{self, Designed};
use generator::codes;
use generator::diagnostics::{Diagnostic, Place};
use golden::simulate::{self, Moved, picture, recording, text};
use std::path::Path;

/// Limits of `--dwell` [s].
const SHORTEST: f64 = 1.0;
const LONGEST: f64 = 600.0;

/// A time of `--dwell`: `2s`, `1500ms`.
pub fn dwell(text: &str) -> Result<f64, String> {
    let time = seconds(text, &[("ms", 1e-3), ("s", 1.0)]).filter(|time| (SHORTEST..=LONGEST).contains(time));
    time.ok_or_else(|| format!("a time from {SHORTEST}s to {LONGEST}s is allowed: 2s, 1500ms"))
}

/// A speed of `--speed` [m/s]: `20mm/s`.
pub fn speed(text: &str) -> Result<f64, String> {
    let speed = seconds(text, &[("um/s", 1e-6), ("mm/s", 1e-3), ("m/s", 1.0)]);
    let speed = speed.filter(|speed| *speed > 0.0 && *speed <= 10.0);
    speed.ok_or_else(|| "a speed above 0 and up to 10m/s is allowed: 20mm/s".to_owned())
}

/// A part of `--noise`: `0.1%`.
pub fn noise(text: &str) -> Result<f64, String> {
    let part = seconds(text, &[("%", 1e-2)]).filter(|part| (0.0..=1.0).contains(part));
    part.ok_or_else(|| "a part from 0% to 100% is allowed: 0.1%".to_owned())
}

/// Runs the command.
pub fn run(to: &SimulateArguments, format: Format) -> Result<Exit, Exit> {
    let (set, _) = input::read_to_look_at(&to.subject.set, to.drive.keys(to.subject.axis.as_deref()), format)?;
    let designed = commands::axis(&set, to.subject.axis.as_deref())?;
    let has_stages = blocks::names(&designed.axis).contains(&"ipc");
    if !has_stages && to.moves.is_none() && to.excited.is_none()
        || to.csv.is_some()
        || to.picture.is_some()
        || to.recorded.is_some()
    {
        commands::block(designed, "ipc")?;
    }
    let moved = moved(designed, to)?;
    let outs = outs(to);
    one_file::allowed(outs, [to.subject.set.set.as_path()])?;
    let [csv, picture, moves, excited, recorded] = outs;
    let noise = to.noise.unwrap_or(0.0);
    let mut files = vec![
        staged(moves, || Ok(recording::moves(designed, moved, to.dwell, noise)))?,
        staged(excited, || self::excited(designed, moved, to.speed, noise))?,
        staged(recorded, || Ok(made(recording::of_block(designed, moved, to.dwell))))?,
    ];
    let simulation = has_stages.then(|| made(simulate::run(designed, moved, to.dwell)));
    if let Some(simulation) = &simulation {
        files.push(staged(csv, || Ok(text::csv(simulation)))?);
        files.push(staged(picture, || {
            let picture = picture::of(simulation, &designed.axis.name);
            Ok(picture.map_or_else(String::new, |picture| picture.svg()))
        })?);
    }
    one_file::commit(files.into_iter().flatten())?;
    let Some(simulation) = simulation else { return Ok(Exit::Done) };
    output::print(text::table(&simulation, designed))?;
    Ok(if text::is_unstable(&simulation) { Exit::Different } else { Exit::Done })
}

/// A file that a run may write.
type Out<'a> = (Option<&'a Path>, Rule<'a>);

/// The files of `--csv`, `--picture`, `--moves`, `--excited` and `--recorded`.
fn outs(to: &SimulateArguments) -> [Out<'_>; 5] {
    let of_csv = Rule::earlier_output(to.force, &|found: &[u8]| found.starts_with(text::HEAD.as_bytes()));
    let of_recording = Rule::earlier_output(to.force, &|found: &[u8]| {
        recording::HEADS.iter().any(|head| found.starts_with(head.as_bytes()))
    });
    [
        (to.csv.as_deref(), of_csv),
        (to.picture.as_deref(), Rule::earlier_picture(to.force)),
        (to.moves.as_deref(), of_recording),
        (to.excited.as_deref(), of_recording),
        (to.recorded.as_deref(), Rule::by_force(to.force)),
    ]
}

/// A file with its text, if it was asked for.
fn staged<'a>((out, rule): Out<'a>, text: impl FnOnce() -> Result<String, Exit>) -> Result<Option<Staged<'a>>, Exit> {
    out.map(|out| one_file::stage(out, text()?.as_bytes(), rule)).transpose()
}

/// The machine of the simulation.
fn moved(designed: &Designed, to: &SimulateArguments) -> Result<Moved, Exit> {
    match to.plant {
        None => Ok(Moved::Drive),
        Some(_) if designed.axis.control.is_rotary => Err(Exit::input(
            codes::USAGE,
            "--plant",
            "the demonstration plant is a translatory axis, this one is rotary",
        )),
        Some(_) => Ok(Moved::Demonstration),
    }
}

/// A recording of a move with the excitation of the axis.
fn excited(designed: &Designed, moved: Moved, speed: Option<f64>, noise: f64) -> Result<String, Exit> {
    if designed.axis.excitation.is_none() {
        let name = &designed.axis.name;
        let found = format!("the axis `{name}` has no block `excitation`");
        let said = Diagnostic::error(codes::NO_SUCH, Place::whole("--excited"), found);
        return Err(Exit::Input(said.instead("excitation = { periods = 8 } in the table of the axis").into()));
    }
    recording::excited(designed, moved, speed, noise).map_err(|why| Exit::input(codes::USAGE, "--excited", why))
}
