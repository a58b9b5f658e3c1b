//! From the text of a value to the value that its parameter's kind demands; ranges are validated where a value is used.

use super::closest;
use crate::codes;
use crate::diagnostics::{Diagnostic, Place};
use crate::parameters::{Kind, Name, Parameter, Value, Word};
use std::borrow::Cow;
use toml::de::DeValue;

/// Why a text is no value of a parameter.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Refused {
    pub(crate) code: &'static str,
    /// what was found, to follow the parameter's name
    pub(crate) found: String,
    pub(crate) allowed: String,
    pub(crate) instead: Option<String>,
}

impl Refused {
    /// The message about a parameter, whose path is as it was written.
    pub(crate) fn diagnostic(self, name: Name, written: &str, place: Place) -> Diagnostic {
        let id = name.parameter().id.map_or(String::new(), |id| format!(" ({id})"));
        let found = format!("`{written}`{id} {}", self.found);
        Diagnostic { instead: self.instead, ..Diagnostic::error(self.code, place, found).allowed(self.allowed) }
    }
}

/// The value of a parameter in an axis list, or of a default.
pub(crate) fn of_text(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    match parameter.kind {
        Kind::Word(words) => of_word(parameter, words, text).map(Value::Word),
        Kind::Words(words) => text
            .split_ascii_whitespace()
            .map(|text| of_word(parameter, words, text))
            .collect::<Result<_, _>>()
            .map(Value::Words),
        Kind::Flags(words) => of_flags(parameter, words, text),
        Kind::Integer { .. } => of_integer(parameter, text),
        Kind::Real { .. } => of_real(parameter, text),
        Kind::Duration { .. } => of_duration(parameter, text),
        Kind::Text => Ok(Value::Text(text.to_owned())),
    }
}

/// The value of a parameter in a set.
pub(crate) fn of_toml(parameter: &Parameter, value: &DeValue<'_>) -> Result<Value, Refused> {
    match (parameter.kind, value) {
        (Kind::Word(_) | Kind::Duration { .. } | Kind::Text, DeValue::String(text)) => of_text(parameter, text),
        (Kind::Word(words), DeValue::Integer(_) | DeValue::Boolean(_)) => {
            of_word(parameter, words, &scalar(value)).map(Value::Word)
        }
        (Kind::Words(words), DeValue::Array(array)) => {
            of_array(parameter, words, array).map_err(|mut wrong| wrong.swap_remove(0).1)
        }
        (Kind::Flags(_), DeValue::String(text)) => of_text(parameter, text),
        (Kind::Flags(_), DeValue::Integer(_)) => of_text(parameter, &scalar(value)),
        (Kind::Integer { .. } | Kind::Real { .. }, DeValue::Integer(_) | DeValue::Float(_)) => {
            of_text(parameter, &scalar(value))
        }
        _ => Err(wrong_type(parameter, value)),
    }
}

/// A text from a file, fit for a message: on one line, and not too long.
pub(crate) fn shown(text: &str) -> String {
    const LONGEST: usize = 100;
    let start: String = text.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    let dots = if text.chars().nth(LONGEST).is_some() { "..." } else { "" };
    format!("`{start}{dots}`")
}

fn of_word(parameter: &Parameter, words: &'static [Word], text: &str) -> Result<&'static str, Refused> {
    let is_spelling = |word: &&Word| {
        let mut spellings = std::iter::once(&word.name).chain(word.also);
        spellings.any(|spelling| spelling.eq_ignore_ascii_case(text))
            || word.number.is_some_and(|number| integer(text) == Some(i64::from(number)))
    };
    words.iter().find(is_spelling).map(|word| word.name).ok_or_else(|| Refused {
        code: codes::WORD,
        found: format!("is {}", shown(text)),
        allowed: parameter.allowed(),
        instead: closest::of(text, words.iter().map(|word| word.name)).map(str::to_owned),
    })
}

fn given_twice(parameter: &Parameter, word: &str) -> Refused {
    let found = format!("names {} twice", shown(word));
    Refused { code: codes::GIVEN_TWICE, found, allowed: parameter.allowed(), instead: None }
}

/// Words with blanks or `|` between, or the number that their bits make.
fn of_flags(parameter: &Parameter, words: &'static [Word], text: &str) -> Result<Value, Refused> {
    if let Some(number) = integer(text) {
        return of_bits(parameter, words, number, text);
    }
    let mut found = Vec::new();
    for part in text.split(|c: char| c.is_ascii_whitespace() || c == '|').filter(|part| !part.is_empty()) {
        let word = of_word(parameter, words, part)?;
        if found.contains(&word) {
            return Err(given_twice(parameter, word));
        }
        found.push(word);
    }
    found.sort_by_key(|found| words.iter().position(|word| word.name == *found));
    if found.len() > 1 {
        found.retain(|found| words.iter().any(|word| word.name == *found && word.number != Some(0)));
    }
    Ok(Value::Words(found))
}

/// The words whose bits make a number, those with more bits first. What is left over means nothing.
fn of_bits(parameter: &Parameter, words: &'static [Word], number: i64, text: &str) -> Result<Value, Refused> {
    let mut rest = number;
    let mut found: Vec<&'static str> = Vec::new();
    for word in words.iter().rev() {
        let bits = i64::from(word.number.unwrap_or(0));
        if bits > 0 && rest & bits == bits && rest >= 0 {
            rest &= !bits;
            found.insert(0, word.name);
        }
    }
    if rest != 0 {
        let found = match rest > 0 {
            true => format!("is {}: the bits 0x{rest:x} stand for nothing alone", shown(text)),
            false => format!("is {}, which has a sign", shown(text)),
        };
        let instead = if rest > 0 { meant(words, number, rest) } else { None };
        return Err(Refused { code: codes::WORD, found, allowed: parameter.allowed(), instead });
    }
    if found.is_empty() {
        found.extend(words.iter().find(|word| word.number == Some(0)).map(|word| word.name));
    }
    Ok(Value::Words(found))
}

/// What a number was probably meant to be of which bits are left over: with all bits of the word that has them. The bit 0x400, which
/// would continue the pattern of ADD_VEL and ADD_ACC, belongs to no word: ADD_JERK has 0x800.
fn meant(words: &[Word], number: i64, rest: i64) -> Option<String> {
    let bits = if rest == 0x400 { 0x800 } else { rest };
    let of = |word: &Word| word.number.map(i64::from).filter(|all| all & bits == bits).map(|all| (word.name, all));
    let (name, all) = words.iter().find_map(of)?;
    Some(format!("0x{:03x}, if {name} is meant", number & !rest | all))
}

/// Words, each an element of an array.
pub(crate) fn of_array(
    parameter: &Parameter,
    words: &'static [Word],
    array: &[toml::Spanned<DeValue<'_>>],
) -> Result<Value, Vec<(usize, Refused)>> {
    let mut found = Vec::with_capacity(array.len());
    let mut wrong = Vec::new();
    for element in array {
        let word = match element.get_ref() {
            DeValue::String(text) => of_word(parameter, words, text),
            other => Err(wrong_type(parameter, other)),
        };
        match word {
            Err(refused) => wrong.push((element.span().start, refused)),
            Ok(word) if found.contains(&word) => wrong.push((element.span().start, given_twice(parameter, word))),
            Ok(word) => found.push(word),
        }
    }
    if wrong.is_empty() { Ok(Value::Words(found)) } else { Err(wrong) }
}

fn of_integer(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    integer(text).map(Value::Integer).ok_or_else(|| {
        let too_large = signed(text).1.bytes().all(|byte| byte.is_ascii_digit()) && real(text).is_some();
        Refused {
            code: if too_large { codes::RANGE } else { codes::NUMBER },
            found: format!("is {}{}", shown(text), if too_large { "" } else { ", no whole number" }),
            allowed: format!("a whole number, {}", parameter.allowed()),
            instead: None,
        }
    })
}

fn of_real(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    real(text).map(Value::Real).ok_or_else(|| Refused {
        code: codes::NUMBER,
        found: format!("is {}, no finite number", shown(text)),
        allowed: format!("a number, {}", parameter.allowed()),
        instead: real(&text.replace(',', ".")).map(|_| text.replace(',', ".")),
    })
}

/// Decimal or 0x, with a sign.
fn integer(text: &str) -> Option<i64> {
    let (negative, digits) = signed(text);
    let (digits, radix) = match digits.get(..2) {
        Some("0x" | "0X") => (&digits[2..], 16),
        _ => (digits, 10),
    };
    // The standard parser takes a second sign.
    let magnitude =
        digits.starts_with(|c: char| c.is_ascii_hexdigit()).then(|| i64::from_str_radix(digits, radix).ok())??;
    Some(if negative { -magnitude } else { magnitude })
}

/// Decimal with point and exponent, or 0x; finite.
fn real(text: &str) -> Option<f64> {
    let (_, digits) = signed(text);
    if digits.starts_with("0x") || digits.starts_with("0X") {
        #[expect(clippy::cast_precision_loss, reason = "rounded to nearest, as a decimal is")]
        return integer(text).map(|n| n as f64);
    }
    // The standard parser takes words such as `inf`.
    let plain = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    plain.then(|| text.parse().ok())?.filter(|x: &f64| x.is_finite())
}

fn signed(text: &str) -> (bool, &str) {
    match text.as_bytes().first() {
        Some(b'-') => (true, &text[1..]),
        Some(b'+') => (false, &text[1..]),
        _ => (false, text),
    }
}

/// A time with its unit, exactly: `1ms`, `62.5us`, `0.1 s`.
fn of_duration(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    let number_end = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let (number, unit) = text.split_at(number_end);
    let refused = |found: String, instead: Option<String>| Refused {
        code: codes::DURATION,
        found,
        allowed: format!("a number with a unit (s, ms, us or ns), {}", parameter.allowed()),
        instead,
    };
    let digits = match unit.trim_start() {
        "s" => 9,
        "ms" => 6,
        "us" | "\u{b5}s" | "\u{3bc}s" => 3,
        "ns" => 0,
        "" => {
            let found = format!("is {}, which has no unit", shown(text));
            return Err(refused(found, real(number).map(|time| with_unit(number, time))));
        }
        _ => return Err(refused(format!("is {}, not a duration", shown(text)), None)),
    };
    let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
    let fraction = fraction.trim_end_matches('0');
    if (whole.is_empty() && fraction.is_empty()) || fraction.contains('.') {
        return Err(refused(format!("is {}, not a duration", shown(text)), None));
    }
    if fraction.len() > digits {
        return Err(refused(format!("is {}, no whole number of nanoseconds", shown(text)), None));
    }
    format!("{whole}{fraction:0<digits$}")
        .parse()
        .map(Value::Duration)
        .map_err(|_| refused(format!("is {}, far too long", shown(text)), None))
}

/// A time without a unit with the units that are likely.
fn with_unit(number: &str, time: f64) -> String {
    // Below a tenth of a millisecond there is hardly a cycle: so small a number is mostly one of seconds.
    match time < 0.1 {
        true => format!("\"{number}s\", if seconds are meant, or \"{number}ms\", if milliseconds are"),
        false => format!("\"{number}ms\", if milliseconds are meant"),
    }
}

fn wrong_type(parameter: &Parameter, value: &DeValue<'_>) -> Refused {
    let needed = match parameter.kind {
        Kind::Word(_) | Kind::Text => "a string",
        Kind::Duration { .. } => "a string: a number with a unit (s, ms, us or ns)",
        Kind::Words(_) => "an array of strings",
        Kind::Flags(_) => "a string or a whole number",
        Kind::Integer { .. } => "a whole number",
        Kind::Real { .. } => "a number",
    };
    let instead = match (parameter.kind, value) {
        (Kind::Integer { .. } | Kind::Real { .. }, DeValue::String(text)) => {
            of_text(parameter, text).ok().map(|value| format!("{}, without quotes", value.text()))
        }
        (Kind::Duration { .. }, DeValue::Integer(_) | DeValue::Float(_)) => {
            let number = scalar(value);
            real(&number).map(|time| with_unit(&number, time))
        }
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

/// A number or a truth value of a set as a list would write it.
fn scalar<'v>(value: &'v DeValue<'_>) -> Cow<'v, str> {
    match value {
        DeValue::Integer(n) if n.radix() == 10 => Cow::Borrowed(n.as_str()),
        DeValue::Integer(n) => match i64::from_str_radix(n.as_str(), n.radix()) {
            Ok(number) => Cow::Owned(number.to_string()),
            Err(_) => Cow::Owned(n.to_string()),
        },
        DeValue::Float(x) => Cow::Borrowed(x.as_str()),
        DeValue::Boolean(true) => Cow::Borrowed("TRUE"),
        DeValue::Boolean(false) => Cow::Borrowed("FALSE"),
        other => Cow::Borrowed(other.type_str()),
    }
}
