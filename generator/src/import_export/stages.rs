//! Other stages of improved position control in the text of an axis: a TOML set or an axis list. Its bytes outside of
//! the stages and of `enable` stay as they are. Whether the result is right is not judged here.

use super::stages_in_list;
use super::stages_in_set;
use crate::axis::Stage;
use crate::codes;
use crate::config::{self, AxisList, Load, Source, file, given, list, project, set};
use crate::diagnostics::{Diagnostic, Report};
use crate::parameters::Name;
use std::path::Path;
use std::sync::Arc;

/// The file with the stages instead of those of an axis, and with the mode DRYRUN. None: they cannot be written there, as
/// the report says.
pub fn with_stages(path: &Path, axis: &str, stages: &[Stage], load: Load<'_>) -> (Option<Vec<u8>>, Report) {
    let mut report = Report::default();
    let written = match file::read(path, None, load) {
        Err(unreadable) => Err(unreadable),
        Ok(source) if file::is_set(path) => in_set(&source, path, axis, stages, load),
        Ok(source) => in_list(&source, axis, stages),
    };
    (written.map_err(|refused| report.extend(refused)).ok(), report)
}

fn in_set(source: &Arc<Source>, path: &Path, name: &str, stages: &[Stage], load: Load<'_>) -> Result<Vec<u8>, Report> {
    let mut report = Report::default();
    let Some(table) = set::parse(source, &mut report) else { return Err(report) };
    let (_, axes) = set::top(source, table.get_ref(), &mut report);
    let axis = axes.iter().find(|axis| axis.name == name);
    let values = axis.map(|axis| set::values_of(source, *axis, &mut report)).unwrap_or_default();
    if report.has_errors() {
        return Err(report);
    }
    if given::list_of(&values, name, path, load).is_some() {
        let (list, setting) = values.text(Name::List).map_or(("", None), |(list, setting)| (list, Some(setting)));
        let found = format!("the axis {name} takes its values from {} and from keys of the set", config::shown(list));
        let place = setting.map_or_else(|| source.whole(), config::Setting::value_place);
        let instead = format!(
            "`axgen tune {list} --cycle-time TIME --apply ...` writes into the list; keys of the set that give stages or enable \
             take their place: take these out first"
        );
        return Err(Diagnostic::error(codes::NOT_WRITTEN, place, found).instead(instead).into());
    }
    let text = String::from_utf8_lossy(&source.bytes);
    stages_in_set::edited(&text, name, stages).map(String::into_bytes).map_err(|found| {
        let instead = format!(
            "[axis.{name}.lr_param.improved_position_control] with enable, and its stages as [[...stage]] or as one array"
        );
        Diagnostic::error(codes::NOT_WRITTEN, source.whole(), found).instead(instead).into()
    })
}

fn in_list(source: &Arc<Source>, name: &str, stages: &[Stage]) -> Result<Vec<u8>, Report> {
    let list: AxisList = project::of_axis(project::lists(source)?, Some(name))?;
    if list.source.is_converted() {
        let found = "the file is an axis of TwinCAT NC, which has no improved position control";
        let instead = "`axgen import` makes a set of the axis: the stages are written there";
        return Err(Diagnostic::error(codes::NOT_WRITTEN, source.whole(), found).instead(instead).into());
    }
    let read = list::read(&list);
    if read.report.has_errors() {
        return Err(read.report);
    }
    let [before, after] = list.around();
    let edited = stages_in_list::edited(list.bytes(), stages);
    list.source.encoding.encoded([before, &edited, after].concat()).map_err(|character| {
        let found = format!("the list has the character {character:?}, which its encoding lacks");
        Diagnostic::error(codes::BYTE, source.whole(), found).into()
    })
}
