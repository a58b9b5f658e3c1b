//! `axgen analyze`: stability of the loop of each axis, its margins, its largest weights; as a table, as JSON, as a picture.

use crate::arguments::{AnalyzeArguments, DriveArguments};
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use crate::output;
use commands::analyze::analyze;
use commands::json;
use generator::analysis;
use generator::blocks::Designed;
use generator::codes;
use generator::config::OptionKey;
use generator::parameters::Name;
use std::path::Path;

impl DriveArguments {
    /// Its options as keys of an axis, or of every axis.
    pub fn keys(&self, axis: Option<&str>) -> Vec<OptionKey> {
        let options = [
            ("--delay", Name::DriveDelay, &self.delay),
            ("--time-constant", Name::DriveTimeConstant, &self.time_constant),
            ("--response", Name::DriveResponse, &self.response),
            ("--response-from", Name::DriveResponseFrom, &self.response_from),
            ("--speed-gain", Name::DriveSpeedGain, &self.speed_gain),
            ("--speed-integral-time", Name::DriveSpeedIntegralTime, &self.speed_integral_time),
        ];
        let given = options.into_iter().filter_map(|(option, name, text)| Some((option, name, text.clone()?)));
        given
            .map(|(option, name, text)| {
                let axis = axis.map(str::to_owned);
                OptionKey { axis, option: option.to_owned(), name, index: [0, 0], text }
            })
            .collect()
    }
}

/// Runs the command.
pub fn run(of: &AnalyzeArguments, format: Format) -> Result<Exit, Exit> {
    let (set, _) = input::read_to_look_at(&of.set, of.drive.keys(of.axis.as_deref()), format)?;
    let axis = of.axis.as_deref();
    if let Some(path) = &of.picture {
        one_file::kept_apart(path.as_path(), [of.set.set.as_path()])?;
        draw(path, commands::axis(&set, axis)?, of.force)?;
    }
    let one = axis.map(|name| commands::axis(&set, Some(name))).transpose()?;
    if of.json {
        output::line(match one {
            Some(designed) => json::text(&analyze(designed)),
            None => json::text(&set.axes.iter().map(analyze).collect::<Vec<_>>()),
        })?;
        return Ok(Exit::Done);
    }
    let axes = one.map_or(set.axes.as_slice(), std::slice::from_ref);
    axes.iter().try_for_each(|designed| output::print(analysis::text(designed)))?;
    Ok(Exit::Done)
}

fn draw(path: &Path, designed: &Designed, force: bool) -> Result<(), Exit> {
    let analysis = analysis::analyze(designed, &designed.axis.drive);
    let picture = golden::analysis::picture(designed, &analysis).ok_or_else(|| {
        let found = format!("no stage of axis {} looks at v_motor: there is no loop to draw", designed.axis.name);
        Exit::input(codes::USAGE, "--picture", found)
    })?;
    one_file::write(Some(path), picture.svg().as_bytes(), Rule::earlier_picture(force))
}
