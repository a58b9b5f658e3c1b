//! `axgen analyze`: whether the loop of each axis is stable, its margins, the weights that it bears; as a table or as JSON.

use crate::arguments::{DriveArguments, SetArguments};
use crate::exit::Exit;
use crate::input;
use crate::messages::Format;
use crate::output;
use generator::analysis::{self, Known, OfDrive};
use generator::blocks::Designed;
use generator::config::OptionKey;
use generator::parameters::Name;
use serde_json::{Value, json};

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
        given.map(|(option, name, text)| OptionKey { option, name, text }).collect()
    }
}

/// Runs the command.
pub fn run(
    arguments: &SetArguments,
    format: Format,
    axis: Option<&str>,
    drive: &DriveArguments,
    is_for_machines: bool,
) -> Result<Exit, Exit> {
    let (set, _) = input::read_to_look_at(arguments, drive.keys(), format)?;
    let axes: Vec<&Designed> = match axis {
        Some(name) => vec![input::axis(&set, Some(name))?],
        None => set.axes.iter().collect(),
    };
    if is_for_machines {
        let all: Vec<Value> = axes.iter().map(|designed| as_json(designed)).collect();
        let one = if axis.is_some() { all.into_iter().next().unwrap_or_default() } else { Value::Array(all) };
        output::line(format!("{one:#}"))?;
        return Ok(Exit::Done);
    }
    axes.iter().try_for_each(|designed| output::print(analysis::text(designed)))?;
    Ok(Exit::Done)
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
