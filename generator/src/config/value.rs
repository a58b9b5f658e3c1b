//! From the text of a value to a value of the parameter's kind. Ranges are validated where a value is used.

use super::closest;
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, on_a_line};
use crate::parameters::{Kind, Name, Parameter, Value, Word, real_text};

/// Why a text is not a value of a parameter.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Refused {
    pub(crate) code: &'static str,
    /// what was found, to be printed after the parameter's name
    pub(crate) found: String,
    pub(crate) allowed: String,
    pub(crate) instead: Option<String>,
}

impl Refused {
    /// The message about a parameter, with its path as written.
    pub(crate) fn diagnostic(self, name: Name, written: &str, place: Place) -> Diagnostic {
        let id = name.parameter().id.map_or(String::new(), |id| format!(" ({id})"));
        let found = format!("`{written}`{id} {}", self.found);
        Diagnostic { instead: self.instead, ..Diagnostic::error(self.code, place, found).allowed(self.allowed) }
    }
}

/// The value at the start of the text after a path, without the quotes of a string; the text that a controller treats as a
/// comment after it; and the positions of both.
pub(crate) struct Spelled<'t> {
    pub(crate) text: &'t str,
    pub(crate) at: usize,
    pub(crate) after: &'t str,
    pub(crate) after_at: usize,
}

pub(crate) fn spelled<'t>(parameter: &Parameter, line: &'t str) -> Spelled<'t> {
    if let Some(end) = line.strip_prefix('"').and_then(|string| string.find('"')) {
        let after = line[end + 2..].trim_ascii_start();
        return Spelled { text: &line[1..=end], at: 1, after, after_at: line.len() - after.len() };
    }
    let end = match parameter.kind {
        Kind::Words(words) | Kind::Flags(words) if !line.starts_with(|c: char| c.is_ascii_digit()) => {
            end_of_words(words, line)
        }
        Kind::Word(words) if is_split(words, line) => line.len(),
        _ => end_of_word(line),
    };
    let (text, rest) = line.split_at(end);
    let after = rest.trim_ascii_start();
    // A second value, digit groups or a decimal comma after a blank are not a comment: the controller would read another
    // value than was meant.
    if after.is_empty() && !line.starts_with('=') {
        return Spelled { text, at: 0, after, after_at: line.len() };
    }
    let second = &after[..end_of_word(after)];
    let is_digits = second.starts_with(|c: char| c.is_ascii_digit() || c == '.' || c == ',') && is_number(text);
    if is_digits || line.starts_with('=') || of_text(parameter, second).is_ok() && !second.is_empty() {
        return Spelled { text: line, at: 0, after: "", after_at: line.len() };
    }
    Spelled { text, at: 0, after, after_at: line.len() - after.len() }
}

pub(super) fn end_of_word(text: &str) -> usize {
    text.find([' ', '\t']).unwrap_or(text.len())
}

/// Whether a text is a word with blanks inside, as manuals print `SET POINT`: no comment after a value.
fn is_split(words: &'static [Word], text: &str) -> bool {
    let (first, rest) = text.split_at(end_of_word(text));
    let is_word = |text: &str| words.iter().any(|word| word.is_spelled(text));
    let joined = |with: &str| text.split_ascii_whitespace().collect::<Vec<_>>().join(with);
    !rest.is_empty() && !is_word(first) && (is_word(&joined("_")) || is_word(&joined("")))
}

/// The end of the words of a parameter at the start of a text; the end of the whole text if a word after them resembles one.
fn end_of_words(words: &'static [Word], line: &str) -> usize {
    let is_between = |c: char| c.is_ascii_whitespace() || c == '|';
    let mut end = 0;
    loop {
        let rest = line[end..].trim_start_matches(is_between);
        let word = rest.split(is_between).next().unwrap_or_default();
        let is_known = words.iter().any(|known| known.is_spelled(word));
        let is_meant = end == 0
            || line[end..].trim_start().starts_with('|')
            || closest::nearest(word, words.iter().map(|word| word.name)).is_some();
        match () {
            () if word.is_empty() => return end,
            () if is_known => end = line.len() - rest.len() + word.len(),
            () if is_meant => return line.len(),
            () => return end,
        }
    }
}

/// A number of IEC 61131-3 with its radix, `16#3E8`: a controller would read only the radix and treat the rest as a comment.
pub(crate) fn with_radix(parameter: &Parameter, text: &[u8], after: &[u8]) -> Option<Refused> {
    let length = after.strip_prefix(b"#")?.iter().take_while(|byte| byte.is_ascii_hexdigit() || **byte == b'_').count();
    let (radix, digits) = (str::from_utf8(text).ok()?, str::from_utf8(&after[1..=length]).ok()?);
    let number = radix.parse().ok().filter(|radix| [2, 8, 16].contains(radix))?;
    let number = i64::from_str_radix(&digits.replace('_', ""), number).ok()?;
    let found = format!("is `{radix}#{digits}`: `#` begins a comment");
    Some(Refused { code: codes::NUMBER, found, allowed: parameter.allowed(), instead: Some(number.to_string()) })
}

pub(crate) fn is_number(text: &str) -> bool {
    real(text).is_some()
}

/// The value of a parameter in an axis list, or of a default.
pub(crate) fn of_text(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    match parameter.kind {
        Kind::Word(words) => of_word(parameter, words, text).map(Value::Word),
        Kind::Words(words) | Kind::Flags(words) => of_flags(parameter, words, text),
        Kind::Integer { .. } => of_integer(parameter, text),
        Kind::Real { .. } => of_real(parameter, text),
        Kind::Duration { .. } => of_duration(parameter, text),
        Kind::Text => Ok(Value::Text(text.to_owned())),
    }
}

/// A text from a file for a message: on one line, and not too long.
pub(crate) fn shown(text: &str) -> String {
    const LONGEST: usize = 100;
    let start: String = text.chars().take(LONGEST).collect();
    let dots = if text.chars().nth(LONGEST).is_some() { "..." } else { "" };
    format!("`{}{dots}`", on_a_line(&start))
}

fn of_word(parameter: &Parameter, words: &'static [Word], text: &str) -> Result<&'static str, Refused> {
    let is_meant = |word: &&Word| {
        word.is_spelled(text) || word.number.is_some_and(|number| integer(text) == Some(i64::from(number)))
    };
    words.iter().find(is_meant).map(|word| word.name).ok_or_else(|| Refused {
        code: codes::WORD,
        found: format!("is {}", shown(text)),
        allowed: parameter.allowed(),
        instead: Some(closest::all_nearest(text, words.iter().map(|word| word.name)).join(" or "))
            .filter(|of| !of.is_empty()),
    })
}

/// Adds a word to those that were found; a duplicate is an error.
pub(super) fn add_word(
    parameter: &Parameter,
    words: &'static [Word],
    text: &str,
    found: &mut Vec<&'static str>,
) -> Result<(), Refused> {
    let word = of_word(parameter, words, text)?;
    if found.contains(&word) {
        let found = format!("names {} twice", shown(word));
        return Err(Refused { code: codes::GIVEN_TWICE, found, allowed: parameter.allowed(), instead: None });
    }
    found.push(word);
    Ok(())
}

/// Words separated by blanks or `|`, or the number made of their bits.
fn of_flags(parameter: &Parameter, words: &'static [Word], text: &str) -> Result<Value, Refused> {
    if let Some(number) = integer(text) {
        return of_bits(parameter, words, number, text);
    }
    let mut found = Vec::new();
    for part in text.split(|c: char| c.is_ascii_whitespace() || c == '|').filter(|part| !part.is_empty()) {
        add_word(parameter, words, part, &mut found)?;
    }
    let is_kept = |word: &&Word| found.contains(&word.name) && (found.len() == 1 || word.number != Some(0));
    Ok(Value::Words(words.iter().filter(is_kept).map(|word| word.name).collect()))
}

/// The words whose bits make a number, those with more bits first. Remaining bits have no meaning.
fn of_bits(parameter: &Parameter, words: &'static [Word], number: i64, text: &str) -> Result<Value, Refused> {
    let mut rest = number;
    let mut found = Vec::new();
    for word in words.iter().rev() {
        let bits = i64::from(word.number.unwrap_or(0));
        if rest & bits == bits && (bits > 0 || found.is_empty()) {
            rest &= !bits;
            found.insert(0, word.name);
        }
    }
    let (found, instead) = match rest {
        0 => return Ok(Value::Words(found)),
        1.. => {
            let found = format!("is {}: the bits 0x{rest:x} stand for nothing alone", shown(text));
            (found, meant(words, number, rest))
        }
        _ => (format!("is {}, which has a sign", shown(text)), None),
    };
    Err(Refused { code: codes::WORD, found, allowed: parameter.allowed(), instead })
}

/// The probable number if bits are left over: with all bits of the word that contains them. The bit 0x400, which would
/// continue the pattern of ADD_VEL and ADD_ACC, belongs to no word: ADD_JERK has 0x800.
fn meant(words: &[Word], number: i64, rest: i64) -> Option<String> {
    let bits = if rest == 0x400 { 0x800 } else { rest };
    let with_all = |word: &Word| word.number.map(i64::from).filter(|all| all & bits == bits).zip(Some(word.name));
    let (all, name) = words.iter().find_map(with_all)?;
    Some(format!("0x{:03x}, if {name} is meant", number & !rest | all))
}

fn of_integer(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    integer(text).map(Value::Integer).ok_or_else(|| {
        let too_large = signed(text).1.bytes().all(|byte| byte.is_ascii_digit()) && real(text).is_some();
        Refused {
            code: if too_large { codes::RANGE } else { codes::NUMBER },
            found: format!("is {}{}", shown(text), if too_large { "" } else { ", no whole number" }),
            allowed: format!("a whole number, {}", parameter.allowed()),
            instead: meant_number(parameter, text).or_else(|| without_unit(parameter, text)),
        }
    })
}

fn of_real(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    real(text).map(Value::Real).ok_or_else(|| Refused {
        code: codes::NUMBER,
        found: format!("is {}, no finite number", shown(text)),
        allowed: format!("a number, {}", parameter.allowed()),
        instead: meant_number(parameter, text).or_else(|| without_unit(parameter, text)),
    })
}

/// Whether a parameter takes a text: no other one is advised.
pub(super) fn is_taken(parameter: &Parameter, text: &str) -> bool {
    let value = match parameter.kind {
        Kind::Integer { .. } => integer(text).map(Value::Integer),
        Kind::Real { .. } => real(text).map(Value::Real),
        Kind::Word(_) | Kind::Words(_) | Kind::Flags(_) | Kind::Duration { .. } | Kind::Text => {
            of_text(parameter, text).ok()
        }
    };
    value.is_some_and(|value| parameter.contains(&value))
}

/// The number that a text of a list with digit groups or a decimal comma means. A single point or comma may be either.
pub(crate) fn meant_number(parameter: &Parameter, text: &str) -> Option<String> {
    // Only groups of three digits belong together: any other second number is a value of its own.
    let closed = text.trim_end_matches(',').replace(" ,", ",").replace(", ", ",");
    let (whole, decimals) = closed.split_at(closed.find(['.', ',']).unwrap_or(closed.len()));
    let plain = grouped(whole, ' ').unwrap_or_else(|| whole.to_owned()) + decimals;
    let point = plain.replace(',', ".");
    // `2000,0` is a whole number, which a parameter without decimals takes.
    let is_zero = |digits: &str| digits.bytes().all(|digit| digit == b'0');
    let point = match point.split_once('.').filter(|(_, digits)| is_zero(digits)) {
        Some((whole, _)) => whole.to_owned(),
        None => point,
    };
    let point = Some(point).filter(|point| text.contains([',', '.']) && is_taken(parameter, point));
    let signs = [(' ', "blank"), ('\'', "sign"), ('_', "sign"), ('.', "point"), (',', "comma")];
    let groups = signs.into_iter().find_map(|(sign, name)| Some((grouped(text, sign)?, sign, name)));
    let groups = groups.filter(|(number, ..)| is_taken(parameter, number));
    match (point, groups) {
        (point, Some((number, sign @ ('.' | ','), name))) if text.matches(sign).count() == 1 => {
            let point = point.map(|point| format!("{point}, or ")).unwrap_or_default();
            Some(format!("{point}{number}, if the {name} separates groups of digits"))
        }
        (_, Some((number, ..))) => Some(number),
        (point, None) => point,
    }
}

/// A number whose digits a sign separates into groups of three; a first group with a leading 0 is the whole part of a decimal.
pub(super) fn grouped(text: &str, sign: char) -> Option<String> {
    let mut groups = text.split(sign);
    let is_digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    let first = signed(groups.next()?).1;
    let is_first = matches!(first.len(), 1..=3) && is_digits(first) && !first.starts_with('0');
    let is_rest = groups.clone().next().is_some() && groups.all(|group| group.len() == 3 && is_digits(group));
    (is_first && is_rest).then(|| text.replace(sign, ""))
}

/// A number written with its unit, converted to the unit of the parameter.
fn without_unit(parameter: &Parameter, text: &str) -> Option<String> {
    let (number, unit) = text.split_at(text.find(|c: char| !c.is_ascii_digit() && c != '.')?);
    let value = real(number)?;
    let meant = match unit {
        "%" if parameter.unit == "0.1 %" => real_text(value * 10.0),
        _ if unit == parameter.unit || unit == "f" => number.to_owned(),
        _ => return None,
    };
    is_taken(parameter, &meant).then_some(meant)
}

/// Decimal or 0x, with a sign.
fn integer(text: &str) -> Option<i64> {
    let (negative, digits) = signed(text);
    let hexadecimal = digits.strip_prefix("0x").or(digits.strip_prefix("0X"));
    let (digits, radix) = hexadecimal.map_or((digits, 10), |digits| (digits, 16));
    // The standard parser would accept a second sign.
    let magnitude =
        digits.starts_with(|c: char| c.is_ascii_hexdigit()).then(|| i64::from_str_radix(digits, radix).ok())??;
    Some(if negative { -magnitude } else { magnitude })
}

/// Decimal with point and exponent, or 0x; finite.
pub(super) fn real(text: &str) -> Option<f64> {
    let (_, digits) = signed(text);
    if digits.starts_with("0x") || digits.starts_with("0X") {
        #[expect(clippy::cast_precision_loss, reason = "rounded to nearest, as a decimal is")]
        return integer(text).map(|n| n as f64);
    }
    // The standard parser would accept words such as `inf`.
    let plain = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    plain.then(|| text.parse().ok())?.filter(|x: &f64| x.is_finite())
}

fn signed(text: &str) -> (bool, &str) {
    let sign = text.as_bytes().first().filter(|sign| matches!(sign, b'-' | b'+'));
    (sign == Some(&b'-'), &text[usize::from(sign.is_some())..])
}

/// A time with its unit, exactly: `1ms`, `62.5us`, `0.1 s`.
fn of_duration(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    let number_end = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let (number, unit) = text.split_at(number_end);
    let refused = |what: &str, instead: Option<String>| Refused {
        code: codes::DURATION,
        found: format!("is {}, {what}", shown(text)),
        allowed: format!("a number with a unit (s, ms, us or ns), {}", parameter.allowed()),
        instead,
    };
    let digits = match unit.trim_start() {
        "s" => 9,
        "ms" => 6,
        "us" | "\u{b5}s" | "\u{3bc}s" => 3,
        "ns" => 0,
        "" => return Err(refused("which has no unit", with_unit(parameter, number))),
        _ => return Err(refused("not a duration", None)),
    };
    let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
    let fraction = fraction.trim_end_matches('0');
    if (whole.is_empty() && fraction.is_empty()) || fraction.contains('.') {
        return Err(refused("not a duration", None));
    }
    if fraction.len() > digits {
        return Err(refused("no whole number of nanoseconds", None));
    }
    let ns = format!("{whole}{fraction:0<digits$}").parse();
    ns.map(Value::Duration).map_err(|_| refused("far too long", None))
}

/// A time without a unit with the units that are likely.
pub(super) fn with_unit(parameter: &Parameter, number: &str) -> Option<String> {
    let of = |unit: &str, word: &str| {
        let time = format!("{number}{unit}");
        is_taken(parameter, &time).then(|| format!("\"{time}\", if {word} are"))
    };
    // Hardly any cycle is shorter than a tenth of a millisecond: such a number is probably in seconds.
    let seconds = real(number).filter(|time| *time < 0.1).and_then(|_| of("s", "seconds"));
    match (seconds, of("ms", "milliseconds")) {
        (Some(seconds), Some(milliseconds)) => Some(format!("{seconds} meant, or {milliseconds}")),
        (seconds, milliseconds) => seconds.or(milliseconds).map(|time| format!("{time} meant")),
    }
}
