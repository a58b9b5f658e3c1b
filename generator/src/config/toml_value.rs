//! From a value of a set to a value of the parameter's kind: its type in TOML, then its text as a list would have it.

use super::value::{Refused, add_word, is_taken, of_text, real, with_unit};
use crate::codes;
use crate::parameters::{Kind, Parameter, Value, Word};
use std::borrow::Cow;
use toml::{Spanned, de::DeValue};

/// The value of a parameter in a set; else all its errors, each with its position.
pub(crate) fn of_toml(parameter: &Parameter, value: &Spanned<DeValue<'_>>) -> Result<Value, Vec<(usize, Refused)>> {
    let found = match (parameter.kind, value.get_ref()) {
        (Kind::Words(words), DeValue::Array(array)) => return of_array(parameter, words, array),
        (kind, value) if toml_types(kind).1.contains(&value.type_str()) => {
            of_text(parameter, &scalar(value)).map_err(|refused| Refused {
                instead: match value {
                    DeValue::Float(x) => whole(parameter, x.as_str()),
                    _ => refused.instead,
                },
                ..refused
            })
        }
        (_, other) => Err(wrong_type(parameter, other)),
    };
    found.map_err(|refused| vec![(value.span().start, refused)])
}

/// The description of a value of this kind in a set, for a message, and the scalar types of TOML that it may have.
fn toml_types(kind: Kind) -> (&'static str, &'static [&'static str]) {
    match kind {
        Kind::Text => ("a string", &["string"]),
        Kind::Word(_) => ("a string", &["string", "integer", "boolean"]),
        Kind::Duration { .. } => ("a string: a number with a unit (s, ms, us or ns)", &["string"]),
        Kind::Words(_) => ("an array of strings", &[]),
        Kind::Flags(_) => ("a string or a whole number", &["string", "integer"]),
        Kind::Integer { .. } => ("a whole number", &["integer", "float"]),
        Kind::Real { .. } => ("a number", &["integer", "float"]),
    }
}

/// Words, each an element of an array.
fn of_array(
    parameter: &Parameter,
    words: &'static [Word],
    array: &[Spanned<DeValue<'_>>],
) -> Result<Value, Vec<(usize, Refused)>> {
    let mut found = Vec::with_capacity(array.len());
    let mut wrong = Vec::new();
    for element in array {
        let added = match element.get_ref() {
            DeValue::String(text) => add_word(parameter, words, text, &mut found),
            other => Err(wrong_type(parameter, other)),
        };
        wrong.extend(added.err().map(|refused| (element.span().start, refused)));
    }
    if wrong.is_empty() { Ok(Value::Words(found)) } else { Err(wrong) }
}

/// The whole number that a float of TOML is: its point separates no groups of digits.
fn whole(parameter: &Parameter, text: &str) -> Option<String> {
    let text = real(text).filter(|x| x.fract() == 0.0)?.to_string();
    is_taken(parameter, &text).then_some(text)
}

fn wrong_type(parameter: &Parameter, value: &DeValue<'_>) -> Refused {
    let (needed, _) = toml_types(parameter.kind);
    let instead = match (parameter.kind, value) {
        (Kind::Integer { .. } | Kind::Real { .. }, DeValue::String(text)) => {
            let value = of_text(parameter, text).ok().filter(|value| parameter.contains(value));
            value.map(|value| format!("{}, without quotes", value.text()))
        }
        (Kind::Duration { .. }, DeValue::Integer(_) | DeValue::Float(_)) => with_unit(parameter, &scalar(value)),
        _ => None,
    };
    Refused {
        code: codes::TYPE,
        found: format!("is of type {}", value.type_str()),
        allowed: match parameter.kind {
            Kind::Text => needed.to_owned(),
            _ => format!("{needed}, {}", parameter.allowed()),
        },
        instead,
    }
}

/// A text, a number or a truth value of a set, as a list would write it.
fn scalar<'v>(value: &'v DeValue<'_>) -> Cow<'v, str> {
    match value {
        DeValue::String(text) => Cow::Borrowed(text),
        DeValue::Integer(n) if n.radix() == 10 => Cow::Borrowed(n.as_str()),
        DeValue::Integer(n) => {
            Cow::Owned(i64::from_str_radix(n.as_str(), n.radix()).map_or_else(|_| n.to_string(), |n| n.to_string()))
        }
        DeValue::Float(x) => Cow::Borrowed(x.as_str()),
        DeValue::Boolean(is_true) => Cow::Borrowed(if *is_true { "TRUE" } else { "FALSE" }),
        other => Cow::Borrowed(other.type_str()),
    }
}
