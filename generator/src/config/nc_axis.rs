//! Axes of TwinCAT NC (PTP), which have no axis list: their largest velocity, Kv and encoder scaling as lines of a list. No
//! file is read.

use super::{axis_name, source::Source, value::shown};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place};
use roxmltree::{Document, Node};
use std::sync::Arc;

/// TwinCAT's placeholder for a name that is the name of the file.
const NAME_OF_FILE: &str = "__FILENAME__";
/// 0.001 mm/s in 1 mm/s, 0.01/s in 1/s, 0.1 um in 1 mm.
const VELOCITY: f64 = 1000.0;
const KV: f64 = 100.0;
const PATH: f64 = 10_000.0;
/// The unit of a task's cycle [ns].
const CYCLE: u64 = 100;

/// An axis with the list made for it.
pub(crate) struct NcAxis {
    /// the list, with the line numbers of the file
    pub(crate) source: Arc<Source>,
    pub(crate) name: Option<String>,
    /// the sources of the list, and its missing values
    pub(crate) said: Diagnostic,
}

/// The axes that a project contains itself, with their values.
pub(crate) fn lists(document: &Document<'_>, source: &Arc<Source>) -> Vec<NcAxis> {
    let cycle = cycle_time(document);
    axes(document)
        .filter(|axis| child(*axis, "AxisPara").is_some())
        .map(|axis| list(axis, cycle, document, source))
        .collect()
}

/// The files that a project names for its axes.
pub(crate) fn files<'d>(document: &'d Document<'_>) -> Vec<&'d str> {
    axes(document).filter_map(|axis| axis.attribute("File")).collect()
}

fn axes<'d, 'i>(document: &'d Document<'i>) -> impl Iterator<Item = Node<'d, 'i>> {
    document.descendants().filter(|node| node.has_tag_name("Axis"))
}

/// The cycle time of the task that runs the axes [ns].
fn cycle_time(document: &Document<'_>) -> Option<u64> {
    let task = document.descendants().find(|node| node.has_tag_name("SafTask"))?;
    task.attribute("CycleTime")?.parse::<u64>().ok().map(|cycle| cycle.saturating_mul(CYCLE))
}

fn child<'d, 'i>(of: Node<'d, 'i>, name: &str) -> Option<Node<'d, 'i>> {
    of.children().find(|child| child.has_tag_name(name))
}

/// A number of an axis that is at least 0, and its position in the file, by the path of elements and the attribute. The error
/// is the text if it is not such a number; `None` without the attribute.
fn number(axis: Node<'_, '_>, path: &[&str], attribute: &str) -> Result<(f64, usize), Option<String>> {
    let node = path.iter().try_fold(axis, |node, name| child(node, name)).ok_or(None)?;
    let attribute = node.attribute_node(attribute).ok_or(None)?;
    let value = attribute.value().parse().ok().filter(|value: &f64| value.is_finite() && *value >= 0.0);
    let unreadable = || Some(format!("{} {}", attribute.name(), shown(attribute.value())));
    Ok((value.ok_or_else(unreadable)?, attribute.range().start))
}

/// The scale of the encoder [mm per increment], its resolution, and the position of its numerator.
fn scale(axis: Node<'_, '_>) -> Result<(f64, [f64; 2], usize), Option<String>> {
    let of = |attribute| number(axis, &["Encoder", "EncPara"], attribute);
    let denominator = of("ScaleFactorDenominator").or_else(|unreadable| match unreadable {
        None => Ok((1.0, 0)),
        unreadable => Err(unreadable),
    });
    let ((numerator, at), (denominator, _)) = (of("ScaleFactorNumerator")?, denominator?);
    let scale = numerator / denominator;
    let unusable = || Some(format!("a scale of {numerator}/{denominator} mm per increment"));
    let resolution = resolution(scale).ok_or_else(unusable)?;
    Ok((scale, resolution, at))
}

/// An axis as lines of a list, each in the line of the file that contains its value.
fn list(axis: Node<'_, '_>, cycle: Option<u64>, document: &Document<'_>, source: &Arc<Source>) -> NcAxis {
    let mut taken: Vec<(u32, String)> = Vec::new();
    let (mut said, mut left) = (Vec::new(), Vec::new());
    for read in values(axis) {
        match read {
            Ok((at, value, lines, ids)) => {
                said.push(format!("{value} is {} ({ids})", lines.join(", ")));
                let row = document.text_pos_at(at).row;
                taken.extend(lines.into_iter().map(|line| (row, line)));
            }
            Err(value) => left.push(value),
        }
    }
    let is_inverse = |path: &[&str]| {
        let node = path.iter().try_fold(axis, |node, name| child(node, name));
        node.and_then(|node| node.attribute("Inverse")).is_some_and(|inverse| inverse == "true")
    };
    if is_inverse(&["Drive", "DrvPara"]) {
        said.push("DrvPara Inverse: the drive counts against the axis: negate what the program writes to it and reads from it".to_owned());
    }
    if is_inverse(&["Encoder", "EncPara"]) {
        said.push("EncPara Inverse: negate what the program reads from the encoder, but not NcToPlc".to_owned());
    }
    taken.sort();
    let place = Place { column: 0, ..source.place(axis.range().start) };
    let name = child(axis, "Name").and_then(|name| name.text()).filter(|name| *name != NAME_OF_FILE);
    NcAxis {
        source: Source::converted(&source.name, text(&taken), source.encoding),
        name: name.and_then(axis_name::of_tree_item),
        said: note(place, name, &said, &left, cycle),
    }
}

/// A value that was accepted: its position, what it is in the file, its lines of a list, and their parameters.
type Accepted = (usize, String, Vec<String>, &'static str);

/// The largest velocity, Kv and the scaling of the encoder.
fn values(axis: Node<'_, '_>) -> [Result<Accepted, Left>; 3] {
    let velocity = number(axis, &["AxisPara", "Velo"], "Maximum").map(|(velocity, at)| {
        let line = format!("getriebe[0].dynamik.vb_max {}", (velocity * VELOCITY).round());
        (at, format!("Velo Maximum {velocity} mm/s"), vec![line], "P-AXIS-00212")
    });
    let kv = number(axis, &["Controller", "CtrPara", "PID"], "PosKp").map(|(kv, at)| {
        let line = format!("getriebe[0].kv {}", (kv * KV).round());
        (at, format!("PID PosKp {kv}/s"), vec![line], "P-AXIS-00099")
    });
    let scale = scale(axis).map(|(scale, [increments, path], at)| {
        let lines = vec![format!("getriebe[0].wegaufz {increments}"), format!("getriebe[0].wegaufn {path}")];
        (at, format!("EncPara scale {scale} mm per increment"), lines, "P-AXIS-00234, 00233")
    });
    let of_scale = "getriebe[0].wegaufz and wegaufn, if a spindle needs them";
    [
        velocity.map_err(|text| ("Velo", "Maximum", text, "getriebe[0].dynamik.vb_max")),
        kv.map_err(|text| ("PID", "PosKp", text, "getriebe[0].kv")),
        scale.map_err(|text| ("EncPara", "ScaleFactorNumerator", text, of_scale)),
    ]
}

/// A value that was not accepted: its element and its attribute, the text found there, and what to write.
type Left = (&'static str, &'static str, Option<String>, &'static str);

/// The message about the axis: what was taken, what is missing, and what cannot be read.
fn note(place: Place, name: Option<&str>, said: &[String], left: &[Left], cycle: Option<u64>) -> Diagnostic {
    let name = name.map(|name| format!(" {}", shown(name))).unwrap_or_default();
    let taken = if said.is_empty() { "nothing could be taken".to_owned() } else { said.join("; ") };
    let mut found = format!("axis{name} of TwinCAT NC, which has no axis list: {taken}");
    let of = |(element, attribute, text, write): &Left, is_missing: bool| match text {
        None => is_missing.then(|| format!("{element} {attribute}: write {write}")),
        Some(text) => (!is_missing).then(|| format!("{element} {text}: write {write}")),
    };
    for (what, is_missing) in [
        ("not in the file, for TwinCAT leaves out what has its default", true),
        ("in the file, but not a usable number", false),
    ] {
        let those: Vec<_> = left.iter().filter_map(|left| of(left, is_missing)).collect();
        if !those.is_empty() {
            found += &format!("; {what}: {}", those.join("; "));
        }
    }
    let cycle = cycle.map_or_else(
        || "the cycle time of the NC's SAF task".to_owned(),
        |ns| format!("the cycle time of the SAF task, {} us", ns as f64 / 1000.0),
    );
    let instead = format!(
        "a TOML set whose axis names this file as its list, with {cycle}, the stages and the type of the axis, if it is rotary"
    );
    Diagnostic::warning(codes::NC_AXIS, place, found).instead(instead)
}

/// Increments and path [0.1 um] of a scale [mm per increment], as whole numbers with nine digits.
fn resolution(scale: f64) -> Option<[f64; 2]> {
    let path = scale * PATH;
    if !(1e-6..1e9).contains(&path) {
        return None;
    }
    let power = |digits: i32| libm::pow(10.0, f64::from(digits));
    let exact = (0..=9).find(|digits| {
        let whole = path * power(*digits);
        (whole - whole.round()).abs() <= whole * 1e-12
    });
    let longest = (0..=9).rev().find(|digits| path * power(*digits) < 1e9).unwrap_or(0);
    let digits = exact.filter(|digits| *digits <= longest).unwrap_or(longest);
    Some([power(digits), (path * power(digits)).round()])
}

/// The text with each line in its row; two lines of one row are in consecutive rows.
fn text(taken: &[(u32, String)]) -> Vec<u8> {
    let mut text = String::new();
    let mut row = 1;
    for (at, line) in taken {
        while row < *at {
            text.push('\n');
            row += 1;
        }
        text += line;
        text.push('\n');
        row += 1;
    }
    text.into_bytes()
}
