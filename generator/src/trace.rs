//! Traceability: the parameters that the blocks of an axis use, and the coefficients that depend on each. A coefficient
//! depends on a parameter if another value of the parameter changes it: the axis is designed again for each. No text of a note
//! is read.

use crate::blocks::{self, Designed};
use crate::check::{self, Checked};
use crate::config::given::{self, GivenAxis};
use crate::config::values::{Key, Setting, Values, key};
use crate::config::{ListOptions, Load};
use crate::diagnostics::{Place, Report};
use crate::parameters::{Kind, Name, Parameter, Value, path_with};
use portable::Literal;
use std::mem::discriminant;
use std::path::Path;

/// A parameter of an axis.
#[derive(Clone, Debug)]
pub struct Traced {
    /// the vendor's id; axgen's own keys have none
    pub id: Option<&'static str>,
    pub path: String,
    /// the effective value
    pub value: String,
    pub unit: &'static str,
    pub meaning: &'static str,
    /// where it is given; `None` if the value is a default
    pub given: Option<Place>,
    /// the coefficients of each block that depend on it, by their positions among all of the block
    pub coefficients: Vec<(&'static str, Vec<usize>)>,
    /// the axis with each other value
    pub versions: Vec<Designed>,
}

/// The numbers of each block.
type Numbers = Vec<(&'static str, Vec<Literal>)>;

/// The parameters that the blocks of an axis use, in the order of the table. Empty if the axis cannot be designed.
///
/// # Errors
/// The set cannot be read.
pub fn parameters(path: &Path, options: &ListOptions, load: Load<'_>, axis: &str) -> Result<Vec<Traced>, Report> {
    let given = given::read(path, options, load)?;
    let mut ignored = Report::default();
    let cycle_time = check::cycle_time(&given.top, given.no_cycle_time.clone(), &mut ignored);
    let of_axis = given.axes.iter().find(|of| of.name == axis);
    let Some((of, cycle_time)) = of_axis.zip(cycle_time) else { return Ok(Vec::new()) };
    Ok(of_given(of, &given.top, cycle_time).unwrap_or_default())
}

fn of_given(of: &GivenAxis, top: &Values, cycle_time: u32) -> Option<Vec<Traced>> {
    let values = of.values.as_ref()?;
    let Checked { axis, effective, .. } = check::axis(&of.name, Some(cycle_time), values, of.home.clone(), false);
    let before = numbers(&Designed::from(axis?));
    let version = |other: (Key, Value)| {
        let cycle_time = match other {
            (name, Value::Duration(ns)) if name == key(Name::CycleTime) => u32::try_from(ns).ok()?,
            _ => cycle_time,
        };
        let checked = check::varied((&of.name, values, of.home.clone()), cycle_time, other);
        checked.axis.map(Designed::from)
    };
    let traced = |((name, index), value): (Key, &Value)| {
        let parameter = name.parameter();
        let source = effective.source((name, index));
        let others = others(parameter, value).into_iter();
        let versions: Vec<Designed> = others.filter_map(|other| version((source, other))).collect();
        let after: Vec<Numbers> = versions.iter().map(numbers).collect();
        Traced {
            id: parameter.id,
            path: path_with(parameter.path, index),
            value: value.text(),
            // A time is written with its unit.
            unit: if matches!(value, Value::Duration(_)) { "" } else { parameter.unit },
            meaning: parameter.meaning,
            given: values.get(source).or(top.get((name, index))).map(Setting::value_place),
            coefficients: changed(&before, &after),
            versions,
        }
    };
    Some(effective.used().map(traced).collect())
}

fn numbers(designed: &Designed) -> Numbers {
    blocks::of_axis(&designed.axis).map(|kind| (kind.name(), kind.coefficients(designed))).collect()
}

/// The numbers of each block that differ in any of some versions of the same block: the real type and the signals of a block
/// do not count as numbers.
fn changed(before: &Numbers, versions: &[Numbers]) -> Vec<(&'static str, Vec<usize>)> {
    let of_block = |(block, old): &(&'static str, Vec<Literal>)| {
        let named = versions.iter().flatten().filter(|(name, _)| name == block).map(|(_, new)| new);
        let new: Vec<&Vec<Literal>> = named.filter(|new| is_same_block(old, new)).collect();
        let changed: Vec<usize> = (0..old.len()).filter(|at| new.iter().any(|new| new[*at] != old[*at])).collect();
        (!changed.is_empty()).then_some((*block, changed))
    };
    before.iter().filter_map(of_block).collect()
}

/// Whether two lists have numbers of the same types.
fn is_same_block(old: &[Literal], new: &[Literal]) -> bool {
    old.iter().map(discriminant).eq(new.iter().map(discriminant))
}

/// Other values of a parameter, near its value: both neighbours of a number, and every other word.
fn others(parameter: &Parameter, value: &Value) -> Vec<Value> {
    const PART: f64 = 1.0 / 64.0;
    let others = match value {
        Value::Integer(n) => vec![Value::Integer(n + 1), Value::Integer(n - 1)],
        Value::Real(x) => vec![Value::Real(x * (1.0 + PART)), Value::Real(x * (1.0 - PART))],
        Value::Duration(ns) => vec![Value::Duration(ns + ns / 64 + 1), Value::Duration(ns - ns / 64)],
        Value::Word(word) => match &parameter.kind {
            Kind::Word(words) => words.iter().map(|of| of.name).filter(|of| of != word).map(Value::Word).collect(),
            Kind::Words(_)
            | Kind::Flags(_)
            | Kind::Integer { .. }
            | Kind::Real { .. }
            | Kind::Duration { .. }
            | Kind::Text => Vec::new(),
        },
        Value::Words(_) | Value::Text(_) => Vec::new(),
    };
    others.into_iter().filter(|other| other != value && parameter.contains(other)).collect()
}
