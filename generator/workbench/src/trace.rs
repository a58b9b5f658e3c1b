//! The lines of a generated file that depend on a value of a stage, found by trial: the value is changed a little, and the lines
//! that differ are its lines. The checksum of a file is not one of them.

use crate::edit::parameter;
use crate::request::Value;
use generator::axis::{Axis, Filter, Mode, Stage};
use generator::blocks::{self, Designed};
use generator::generate::axis_files;
use generator::target::{File, Target};
use serde::Serialize;
use std::collections::BTreeSet;

/// A value of a stage, and its lines.
#[derive(Clone, Debug, Serialize)]
pub struct Traced {
    pub stage: usize,
    pub value: &'static str,
    /// the vendor's id
    pub parameter: Option<&'static str>,
    pub path: String,
    /// the coefficients of the axis's blocks that depend on it
    pub coefficients: Vec<String>,
    pub lines: Vec<Line>,
}

#[derive(Clone, Debug, Serialize)]
pub struct Line {
    pub file: String,
    /// from 1
    pub line: usize,
    /// the coefficient that the line declares
    pub coefficient: Option<String>,
}

const VALUES: [(Value, &str); 4] =
    [(Value::F0, "f0"), (Value::Q, "q"), (Value::Damping, "damping"), (Value::Weight, "weight")];

/// The lines of every value of an axis in the files of a target.
pub fn trace(designed: &Designed, target: Target) -> Vec<Traced> {
    let files = |designed: &Designed| axis_files(designed, &[target]).unwrap_or_default();
    let before = (files(designed), coefficients(designed));
    let stages = designed.axis.ipc.stage.iter().enumerate().filter_map(|(n, stage)| Some((n, stage.as_ref()?)));
    let each = stages.flat_map(|(n, stage)| VALUES.map(|value| (n, stage, value)));
    let traced = each.filter_map(|(n, stage, (value, word))| {
        let changed = Designed::from(changed(&designed.axis, n, value)?);
        let after = coefficients(&changed);
        let differ = before.1.iter().zip(&after).filter(|(old, new)| old != new);
        let coefficients: Vec<String> = differ.map(|((path, _), _)| path.clone()).collect();
        let lines = lines(&before.0, &files(&changed), &coefficients);
        let (name, [stage, filter]) = parameter(stage, n, value);
        let known = name.parameter();
        let path = known.path.replace("[i]", &format!("[{stage}]")).replace("[k]", &format!("[{filter}]"));
        Some(Traced { stage: n, value: word, parameter: known.id, path, coefficients, lines })
    });
    traced.collect()
}

/// The axis with another value; `None` if the stage does not have it.
fn changed(axis: &Axis, index: usize, value: Value) -> Option<Axis> {
    const LITTLE: f64 = 1.001;
    let mut axis = axis.clone();
    let stage = axis.ipc.stage[index].as_mut()?;
    match value {
        Value::F0 | Value::Q => {
            let [f0, q_factor] = bandpass(stage)?;
            if value == Value::F0 { *f0 *= LITTLE } else { *q_factor *= LITTLE }
        }
        Value::Damping => match &mut stage.mode {
            Mode::Direct { .. } => return None,
            Mode::Indirect { osc_damping } | Mode::SetPoint { osc_damping } => *osc_damping *= LITTLE,
        },
        Value::Weight => stage.weight_fact_num = stage.weight_fact_num.saturating_sub(1),
    }
    Some(axis)
}

fn bandpass(stage: &mut Stage) -> Option<[&mut f64; 2]> {
    stage.filter.iter_mut().find_map(|filter| match filter {
        Filter::Bandpass { f0, q_factor, .. } => Some([f0, q_factor]),
        Filter::NoFilter | Filter::Allpass { .. } => None,
    })
}

/// The constants of all blocks of an axis, by their paths.
fn coefficients(designed: &Designed) -> Vec<(String, String)> {
    let blocks = blocks::blocks(designed).unwrap_or_default();
    let constants = blocks.into_iter().flat_map(|block| block.program.constants);
    constants.map(|constant| (constant.path, format!("{:?}", constant.value))).collect()
}

fn lines(before: &[File], after: &[File], coefficients: &[String]) -> Vec<Line> {
    let flat: Vec<(String, &String)> = coefficients.iter().map(|path| (in_text(path), path)).collect();
    let mut found = Vec::new();
    for (old, new) in before.iter().zip(after) {
        // Texts of comments may break at other words: the lines below them stay what they are.
        let stays: BTreeSet<&str> = new.text.lines().collect();
        let differ = old.text.lines().enumerate().filter(|(_, text)| !stays.contains(text));
        for (at, text) in differ.filter(|(_, text)| !text.contains("checksum")) {
            let words = || text.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
            let coefficient = flat.iter().find(|(name, _)| words().any(|word| word.eq_ignore_ascii_case(name)));
            found.push(Line {
                file: old.name.clone(),
                line: at + 1,
                coefficient: coefficient.map(|(_, path)| (*path).clone()),
            });
        }
    }
    found
}

/// The name of a coefficient in a file: `stage0_weight`.
fn in_text(path: &str) -> String {
    path.replace(['[', ']'], "").replace('.', "_")
}
