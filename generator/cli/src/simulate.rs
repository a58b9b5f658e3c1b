//! `axgen simulate`: the block of an axis in a closed loop, off against on, as a table, as CSV and as a picture.

use crate::arguments::{DriveArguments, SetArguments, SimulateArguments};
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use crate::output;
use crate::run::block_of;
use crate::times;
use generator::codes;
use golden::simulate::{self, Moved, picture, text};
use golden::svg;
use std::path::PathBuf;

/// Limits of `--dwell` [s].
const SHORTEST: f64 = 1.0;
const LONGEST: f64 = 600.0;

/// A time of `--dwell`: `2s`, `1500ms`.
pub fn dwell(text: &str) -> Result<f64, String> {
    let time = times::seconds(text, &[("ms", 1e-3), ("s", 1.0)]);
    let allowed = || format!("a time from {SHORTEST}s to {LONGEST}s is allowed: 2s, 1500ms");
    time.filter(|time| (SHORTEST..=LONGEST).contains(time)).ok_or_else(allowed)
}

/// Runs the command.
pub fn run(
    arguments: &SetArguments,
    format: Format,
    axis: Option<&str>,
    drive: &DriveArguments,
    to: &SimulateArguments,
) -> Result<Exit, Exit> {
    let (set, _) = input::read_to_look_at(arguments, drive.keys(), format)?;
    let designed = input::axis(&set, axis)?;
    block_of(designed, "ipc")?;
    let moved = if to.plant.is_some() { Moved::Demonstration } else { Moved::Drive };
    if moved == Moved::Demonstration && designed.axis.control.is_rotary {
        return Err(Exit::input(
            codes::USAGE,
            "--plant",
            "the demonstration plant is a translatory axis, this one is rotary",
        ));
    }
    let is_csv = |found: &[u8]| found.starts_with(text::HEAD.as_bytes());
    let is_picture = |found: &[u8]| found.starts_with(svg::HEAD.as_bytes());
    let [of_csv, of_picture] = [Rule::own(to.force, &is_csv), Rule::own(to.force, &is_picture)];
    one_file::told_apart(&to.csv.iter().chain(&to.picture).map(PathBuf::as_path).collect::<Vec<_>>())?;
    for (out, rule) in [(to.csv.as_deref(), of_csv), (to.picture.as_deref(), of_picture)] {
        let Some(out) = out else { continue };
        one_file::kept_apart(out, [arguments.set.as_path()])?;
        rule.allows(out)?;
    }
    let simulation =
        simulate::run(designed, moved, to.dwell).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
    let csv = to.csv.as_deref().map(|path| one_file::stage(path, text::csv(&simulation).as_bytes(), of_csv));
    let drawn = |path| one_file::stage(path, picture::svg(&simulation, &designed.axis.name).as_bytes(), of_picture);
    let staged = [csv.transpose()?, to.picture.as_deref().map(drawn).transpose()?];
    one_file::commit(staged.into_iter().flatten())?;
    output::print(text::table(&simulation, designed))?;
    Ok(if text::is_unstable(&simulation) { Exit::Different } else { Exit::Done })
}
