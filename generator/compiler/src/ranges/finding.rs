//! The properties of a program that cannot be proven, in words.

use super::real::Interval;
use super::value::Value;
use super::whole::Whole;
use crate::dump::Dump;
use crate::program::{Expr, Program, Statement};
use std::fmt;

/// A property that cannot be proven.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    pub code: &'static str,
    /// what was found, and where
    pub text: String,
}

pub(super) enum Kind {
    /// the operand of a conversion to an integer
    Conversion(Interval),
    /// the result of an operation before it wraps around
    Overflow(Whole),
    /// a division of integers whose divisor may be 0
    Division,
}

impl Finding {
    pub(super) fn of(program: &Program, kind: Kind, part: &Expr, statement: Option<&Statement>) -> Self {
        let part = Dump::of(program).expression(part);
        let place = statement.map_or_else(String::new, |statement| Dump::of(program).statement(statement));
        let (code, found) = match kind {
            Kind::Conversion(x) => ("conversion", format!("`{part}`: its operand is {}", words(Value::Real(x)))),
            Kind::Overflow(of) => ("overflow", format!("`{part}` is {}", words(Value::Whole(of)))),
            Kind::Division => ("division", format!("`{part}`: its divisor may be 0")),
        };
        Self { code, text: format!("{found}, in `{place}`") }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.code, self.text)
    }
}

/// Values in words.
pub(super) fn words(value: Value) -> String {
    match value {
        Value::Bool([false, true]) => "TRUE".to_owned(),
        Value::Bool([true, false]) => "FALSE".to_owned(),
        Value::Bool(_) => "FALSE or TRUE".to_owned(),
        Value::Whole(whole) if whole.low == whole.high => whole.low.to_string(),
        Value::Whole(whole) => format!("{} to {}", whole.low, whole.high),
        Value::Real(interval) if !interval.has_number() => "no number".to_owned(),
        Value::Real(Interval { low, high, nan }) => {
            let numbers =
                if low.to_bits() == high.to_bits() { format!("{low:?}") } else { format!("{low:?} to {high:?}") };
            if nan { format!("{numbers}, or no number") } else { numbers }
        }
    }
}
