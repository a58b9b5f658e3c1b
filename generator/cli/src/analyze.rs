//! `axgen analyze`: stability of the loop of each axis, its margins, its largest weights; as a table, as JSON, as a picture.

use crate::arguments::{AnalyzeArguments, DriveArguments};
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use crate::output;
use generator::analysis::{self, Known, OfDrive};
use generator::blocks::Designed;
use generator::codes;
use generator::config::OptionKey;
use generator::parameters::Name;
use golden::svg;
use serde_json::{Value, json};
use std::path::Path;

impl DriveArguments {
    /// Its options as keys.
    pub fn keys(&self) -> Vec<OptionKey> {
        let options = [
            ("--delay", Name::DriveDelay, &self.delay),
            ("--time-constant", Name::DriveTimeConstant, &self.time_constant),
            ("--response", Name::DriveResponse, &self.response),
            ("--response-from", Name::DriveResponseFrom, &self.response_from),
            ("--speed-gain", Name::DriveSpeedGain, &self.speed_gain),
            ("--speed-integral-time", Name::DriveSpeedIntegralTime, &self.speed_integral_time),
        ];
        let given = options.into_iter().filter_map(|(option, name, text)| Some((option, name, text.clone()?)));
        given.map(|(option, name, text)| OptionKey { option: option.to_owned(), name, index: [0, 0], text }).collect()
    }
}

/// Runs the command.
pub fn run(of: &AnalyzeArguments, format: Format) -> Result<Exit, Exit> {
    let (set, _) = input::read_to_look_at(&of.set, of.drive.keys(), format)?;
    let axis = of.axis.as_deref();
    if let Some(path) = &of.picture {
        one_file::kept_apart(path.as_path(), [of.set.set.as_path()])?;
        draw(path, input::axis(&set, axis)?, of.force)?;
    }
    let axes: Vec<&Designed> = match axis {
        Some(name) => vec![input::axis(&set, Some(name))?],
        None => set.axes.iter().collect(),
    };
    if of.json {
        let all: Vec<Value> = axes.iter().map(|designed| as_json(designed)).collect();
        let one = if axis.is_some() { all.into_iter().next().unwrap_or_default() } else { Value::Array(all) };
        output::line(format!("{one:#}"))?;
        return Ok(Exit::Done);
    }
    axes.iter().try_for_each(|designed| output::print(analysis::text(designed)))?;
    Ok(Exit::Done)
}

fn draw(path: &Path, designed: &Designed, force: bool) -> Result<(), Exit> {
    let analysis = analysis::analyze(designed, &designed.axis.drive);
    let picture = golden::analysis::svg(designed, &analysis).ok_or_else(|| {
        let found = format!("no stage of axis {} looks at v_motor: there is no loop to draw", designed.axis.name);
        Exit::input(codes::USAGE, "--picture", found)
    })?;
    let is_picture = |found: &[u8]| found.starts_with(svg::HEAD.as_bytes());
    one_file::write(Some(path), picture.as_bytes(), Rule::earlier_output(force, &is_picture))
}

fn as_json(designed: &Designed) -> Value {
    let axis = &designed.axis;
    let drives: Vec<Value> = analysis::analyze(designed, &axis.drive).drives.iter().map(drive_json).collect();
    json!({ "axis": axis.name, "cycle_time_ns": axis.cycle_time_ns, "drives": drives })
}

fn drive_json(of: &OfDrive) -> Value {
    let stages: Vec<Value> = (of.stages.iter())
        .map(|stage| {
            json!({
                "stage": stage.stage,
                "weight": stage.weight,
                "phase_at_f0_deg": stage.phase_at_f0_deg,
                "largest_stable_weight": stage.largest_stable_weight,
                "largest_weight": stage.largest_weight,
            })
        })
        .collect();
    let (delay, time_constant, response) = match &of.drive {
        Known::Delay { cycles, time_constant } => (Some(cycles), time_constant.as_ref(), None),
        Known::Measured(measured) => (None, None, Some(&measured.file)),
    };
    json!({
        "delay_cycles": delay,
        "time_constant_s": time_constant,
        "response": response,
        "stable": of.margins.stable,
        "ms": of.margins.ms.map(|[ms, _]| ms),
        "ms_hz": of.margins.ms.map(|[_, hz]| hz),
        "gain_margin_db": of.margins.gain_db,
        "phase_margin_deg": of.margins.phase_deg,
        "stages": stages,
    })
}
