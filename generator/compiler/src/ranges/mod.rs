//! The range analysis: an interval for every variable of a program, for any bit patterns in its state, inputs and parameter
//! sets, followed through every branch of `step`.
//!
//! It is proven that outputs are finite numbers within their limits, that ids and words are from their lists, that no
//! integer overflows, that no conversion leaves its range, and that no integer is divided by 0.

mod decide;
mod finding;
mod known;
mod learn;
mod real;
mod value;
mod walk;
mod whole;

pub use decide::run as decide;
pub use finding::Finding;
use finding::words;
pub use real::Interval;
pub use value::Value;
pub use whole::Whole;

use crate::pass::Defect;
use crate::program::{Expr, Origin, Program, Var, Variable, values};
use std::collections::BTreeSet;
use walk::Walk;
use whole::{Names, number};

/// The largest magnitude allowed for an output with this path, in the block's own real type.
pub type Limit<'l> = (&'l str, f64);

/// The proven properties of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// the possible values of each output after a cycle, in the order of the outputs
    pub outputs: Vec<Value>,
    /// for an integer that is always one of some numbers: these numbers
    pub numbers: Vec<Option<Vec<i64>>>,
    /// properties that cannot be proven
    pub findings: Vec<Finding>,
    /// the `if`s of `step` that always take the same branch, by their position in the text, and the answer to their conditions
    pub decided: Vec<(usize, bool)>,
}

impl Shown {
    /// Rejects a block if a property cannot be proven.
    ///
    /// # Errors
    /// All properties that cannot be proven.
    pub fn refuse(&self, block: &str) -> Result<(), Defect> {
        if self.findings.is_empty() {
            return Ok(());
        }
        let findings: Vec<String> = self.findings.iter().map(Finding::to_string).collect();
        Err(Defect { pass: "ranges", message: format!("block {block}: {}", findings.join("; ")) })
    }

    /// The values of each output, in words.
    pub fn lines(&self, program: &Program) -> Vec<String> {
        let outputs = program.outputs.iter().zip(&self.outputs).zip(&self.numbers);
        let words = |((output, value), numbers): ((&Variable, &Value), &Option<Vec<i64>>)| {
            let values = numbers.as_ref().map_or_else(|| words(*value), |numbers| listed(numbers.iter()));
            format!("{}: {values}", output.path)
        };
        outputs.map(words).collect()
    }
}

/// Proves properties of a verified program.
pub fn run(program: &Program, limits: &[Limit<'_>]) -> Shown {
    let names = names(program);
    let mut init = Walk::new(program, names.clone());
    init.list(&program.init);
    let mut walk = Walk::new(program, names);
    walk.list(&program.step);
    let vars = (0..program.outputs.len()).map(Var::Output);
    let outputs: Vec<Value> = vars.map(|var| walk.known.value(walk.place(var))).collect();
    let numbers = outputs.iter().map(|value| match value {
        Value::Whole(whole) => walk.known.names.numbers(*whole),
        _ => None,
    });
    let numbers: Vec<Option<Vec<i64>>> = numbers.collect();
    let mut findings = init.findings;
    findings.extend(walk.findings);
    let lists = lists(program);
    for (index, (output, value)) in program.outputs.iter().zip(&outputs).enumerate() {
        if program.in_made(output).is_some() {
            // The block that takes the set checks every number of it.
            continue;
        }
        let limit = limits.iter().find(|(path, _)| *path == output.path).map(|(_, limit)| *limit);
        findings.extend(of_output(&output.path, *value, limit, numbers[index].as_deref(), lists[index].as_ref()));
    }
    Shown { outputs, numbers, findings, decided: walk.decided }
}

/// Reports limits that an output may violate.
fn of_output(
    path: &str,
    value: Value,
    limit: Option<f64>,
    numbers: Option<&[i64]>,
    list: Option<&BTreeSet<i64>>,
) -> Option<Finding> {
    let finding = |code, text| Some(Finding { code, text });
    match value {
        Value::Real(interval) if !interval.is_finite() => {
            finding("finite", format!("the output {path} is {}", words(value)))
        }
        Value::Real(interval) => {
            let limit = limit.filter(|limit| interval.magnitude() > *limit)?;
            finding("limit", format!("the output {path} is {}, its limit is {limit:?}", words(value)))
        }
        Value::Whole(_) => {
            let list = list?;
            if numbers.is_some_and(|numbers| numbers.iter().all(|number| list.contains(number))) {
                return None;
            }
            let found = numbers.map_or_else(|| words(value), |numbers| listed(numbers.iter()));
            finding("list", format!("the output {path} is {found}; its list is {}", listed(list.iter())))
        }
        Value::Bool(_) => None,
    }
}

fn listed<'n>(numbers: impl Iterator<Item = &'n i64>) -> String {
    numbers.map(i64::to_string).collect::<Vec<_>>().join(", ")
}

/// The named numbers of a program, ids and words first.
fn names(program: &Program) -> Names {
    let of = |is_first: bool| {
        let constants = program.constants.iter();
        constants.filter(move |constant| is_first != matches!(constant.origin, Origin::Coefficient(_)))
    };
    let mut literals = Vec::new();
    for statement in program.statements() {
        statement.expressions(&mut |expr| {
            if let Expr::Literal(literal) = expr {
                literals.extend(number(*literal));
            }
        });
    }
    let constants = of(true).chain(of(false)).filter_map(|constant| number(constant.value));
    Names::of(constants.chain(literals))
}

/// For each output that is an id or a word: its possible numbers.
fn lists(program: &Program) -> Vec<Option<BTreeSet<i64>>> {
    let signals = values::of_outputs(program);
    let of = |constants: &mut dyn Iterator<Item = usize>| -> BTreeSet<i64> {
        constants.filter_map(|index| number(program.constants[index].value)).collect()
    };
    let list = |(index, output): (usize, &Variable)| {
        let signal = signals.iter().find(|signal| signal.var == Var::Output(index));
        match signal {
            Some(signal) => Some(of(&mut signal.constants.iter().copied())),
            None if output.path == ERROR_ID => {
                let is_id = |index: &usize| {
                    let constant = &program.constants[*index];
                    constant.origin == Origin::Function && constant.path.starts_with("error_")
                };
                Some(of(&mut (0..program.constants.len()).filter(is_id)))
            }
            None => None,
        }
    };
    program.outputs.iter().enumerate().map(list).collect()
}

/// The output that is always an id.
const ERROR_ID: &str = "error_id";
