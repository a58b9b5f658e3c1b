//! Another value of a stage in the text of the user.

use crate::request::{Subject, Value};
use crate::session::{Session, load};
use generator::axis::{Filter, Stage};
use generator::blocks::Designed;
use generator::diagnostics::Report;
use generator::import_export::with_value;
use generator::parameters::Name;

/// The parameter of a value of a stage, with its indices.
pub fn parameter(stage: &Stage, index: usize, value: Value) -> (Name, [u32; 2]) {
    let is_bandpass = |filter: &Filter| matches!(filter, Filter::Bandpass { .. });
    let filter = u32::from(!is_bandpass(&stage.filter[0]));
    let index = u32::try_from(index).unwrap_or(u32::MAX);
    match value {
        Value::F0 => (Name::FilterF0, [index, filter]),
        Value::Q => (Name::FilterQ, [index, filter]),
        Value::Damping => (Name::OscDamping, [index, 0]),
        Value::Weight => (Name::WeightFactNum, [index, 0]),
    }
}

/// Writes a value into the file that has it; returns the name of the file.
pub fn edit(
    session: &mut Session,
    of: &Subject,
    designed: &Designed,
    (index, value): (usize, Value),
    to: f64,
) -> Result<String, Report> {
    let stage = designed.axis.ipc.stage.get(index).and_then(Option::as_ref);
    let Some(stage) = stage else { return Ok(String::new()) };
    let text = match value {
        Value::Weight => (to * f64::from(stage.weight_fact_denom)).round().to_string(),
        Value::F0 | Value::Q | Value::Damping => to.to_string(),
    };
    let key = parameter(stage, index, value);
    let name = designed.axis.name.as_str();
    let load = load(&session.files);
    let write = |key| with_value(of.path(), &of.options(), (name, key), &text, &load);
    let written = match value {
        // An older list has the damping below its filter.
        Value::Damping => write(key).or_else(|refused| write((Name::FilterDamping, key.1)).map_err(|_| refused)),
        Value::F0 | Value::Q | Value::Weight => write(key),
    };
    let (file, bytes) = written?;
    drop(load);
    let known = session.files.0.contains_key(&file);
    let file = if known { file } else { file.file_name().map(Into::into).unwrap_or(file) };
    let name = file.to_string_lossy().into_owned();
    session.files.0.insert(file, bytes);
    Ok(name)
}
