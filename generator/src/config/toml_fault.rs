//! Errors of TOML's parser, one message per line, for readers who know axis lists: which character is wrong, and what to
//! write instead. Nothing that TOML accepts is parsed here.

use super::source::Source;
use super::value::{grouped, is_number, shown};
use crate::codes;
use crate::diagnostics::{Diagnostic, on_a_line};
use std::collections::BTreeMap;

/// A place in a line, what was found there, and what to write instead.
type Fault = (usize, String, String);

/// At most this number of lines with faults is listed: the others follow from the first.
const LINES: usize = 20;

/// Longer lines, in bytes, are not examined: they are not hand-written.
const LONGEST: usize = 1000;

/// The messages for the faults of a text, each with the position and the words of the parser.
pub(super) fn said(source: &Source, text: &str, faults: impl Iterator<Item = (usize, String)>) -> Vec<Diagnostic> {
    let lines = first_of_each_line(text, faults);
    let mut unclosed = unclosed(text);
    // What the parser says about the lines below follows from it. Where something is closed that was not opened, what it says
    // about the lines above does too, unless another fault explains that.
    let is_cause = unclosed.as_ref().is_some_and(|(at, ..)| text[*at..].starts_with([']', '}']));
    let last = unclosed.as_ref().map_or(text.len(), |(at, ..)| *at);
    let last = text[..last].rfind('\n').map_or(0, |end| end + 1);
    let error = |at: usize, found: String| Diagnostic::error(codes::SYNTAX, source.place(at), found);
    let mut said = Vec::new();
    for (start, (column, words)) in lines.into_iter().take_while(|(start, _)| *start <= last).take(LINES) {
        let line = text[start..].lines().next().unwrap_or_default();
        let is_comment = line.trim_start().starts_with('#');
        let fault = match () {
            () if is_comment || line.len() > LONGEST => None,
            () if line.trim().starts_with('{') && text[..start].trim().is_empty() => Some(json(line)),
            () => fault(line, column.min(line.len()), &words),
        };
        match fault {
            Some((at, found, instead)) => {
                said.push(error(start + at, on_a_line(&found)).instead(on_a_line(&instead)));
                unclosed = unclosed.filter(|_| start < last);
            }
            None if unclosed.is_none() || start < last && !is_cause => {
                said.push(error(start + column, format!("no TOML: {words}")))
            }
            None => {}
        }
    }
    said.extend(unclosed.map(|(at, found, instead)| error(at, found).instead(instead)));
    said
}

/// The first fault of each line, by the start of the line: its column, and the words of the parser.
fn first_of_each_line(text: &str, faults: impl Iterator<Item = (usize, String)>) -> BTreeMap<usize, (usize, String)> {
    let mut lines = BTreeMap::new();
    let mut seen = 0..0;
    for (at, words) in faults {
        // A position inside a character would have no column.
        let at = (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        if !seen.contains(&at) {
            let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
            seen = start..text[at..].find('\n').map_or(text.len(), |end| at + end) + 1;
            lines.entry(start).or_insert((at - start, words));
        }
        if lines.len() > LINES {
            break;
        }
    }
    lines
}

fn json(line: &str) -> Fault {
    let found = "`{` begins no line of TOML: the file seems to be JSON".to_owned();
    (line.len() - line.trim_start().len(), found, "key = value, and [axis.X] above what belongs to an axis".to_owned())
}

/// A bracket that is not closed or closes nothing, or a string that is not closed within brackets or over lines. The parser
/// only has the place where it cannot go on, which is usually the end of the text.
fn unclosed(text: &str) -> Option<Fault> {
    let closing = |open| if open == '[' { ']' } else { '}' };
    let without_end =
        |&(at, open): &(usize, char)| (at, format!("`{open}` without its end"), closing(open).to_string());
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut at = 0;
    while let Some(sign) = text[at..].chars().next() {
        let rest = &text[at..];
        let line = || rest.find('\n').unwrap_or(rest.len());
        let mut length = sign.len_utf8();
        match sign {
            '#' => length = line(),
            '"' | '\'' => match string(rest) {
                (_, Some(end)) => length = end,
                (quotes, None) if open.is_empty() && quotes.len() == 1 => length = line(),
                (quotes, None) => {
                    return Some((at, "a string without its end".to_owned(), format!("{quotes} at its end")));
                }
            },
            '[' | '{' => open.push((at, sign)),
            ']' | '}' => match open.pop() {
                Some((_, opened)) if closing(opened) == sign => {}
                Some(opened) => return Some(without_end(&opened)),
                None => return Some((at, format!("`{sign}` closes nothing"), format!("the line without `{sign}`"))),
            },
            '\n' => match open.last() {
                Some(opened) if begins_statement(&rest[1..], opened.1) => return Some(without_end(opened)),
                _ => {}
            },
            _ => {}
        }
        at += length;
    }
    open.last().map(without_end)
}

/// The quotes of the string at the start of a text, and its end after them.
fn string(text: &str) -> (&str, Option<usize>) {
    let is_long = [r#"""""#, "'''"].iter().any(|quotes| text.starts_with(quotes));
    let quotes = &text[..if is_long { 3 } else { 1 }];
    let mut is_escaped = false;
    let mut signs = text.char_indices().skip(quotes.len()).take_while(|(_, sign)| is_long || *sign != '\n');
    let end = signs.find(|(at, sign)| {
        let is_plain = !std::mem::take(&mut is_escaped);
        is_escaped = is_plain && *sign == '\\' && quotes.starts_with('"');
        is_plain && text[*at..].starts_with(quotes)
    });
    (quotes, end.map(|(at, _)| at + quotes.len()))
}

/// Whether a text within this bracket begins with the name of a table, or within an array with a key and its value.
fn begins_statement(text: &str, open: char) -> bool {
    let line = text.lines().next().unwrap_or_default().trim_start();
    let is_letter = |letter: char| letter.is_ascii_alphabetic();
    let after = line.trim_start_matches(|letter: char| letter.is_ascii_alphanumeric() || "._-".contains(letter));
    line.starts_with('[') && line.trim_start_matches('[').starts_with(is_letter)
        || open == '[' && line.starts_with(is_letter) && after.trim_start().starts_with('=')
}

/// The fault in a line about which the parser says these words.
fn fault(line: &str, column: usize, words: &str) -> Option<Fault> {
    let start = line.len() - line.trim_start().len();
    let text = line.trim();
    if let Some(sign) = ["//", "/*", "(*", "(", ";", "'"].into_iter().find(|sign| text.starts_with(sign)) {
        return Some((start, format!("`{sign}` begins no comment of TOML"), "`#` before a comment".to_owned()));
    }
    if let Some(at) = line.find(['\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}']) {
        let found = "a typographic quote, as a text processor writes it".to_owned();
        return Some((at, found, "\" around a string".to_owned()));
    }
    if words.contains("duplicate key") {
        return Some((start, "the key is given twice".to_owned(), "one of the two lines".to_owned()));
    }
    if ["escape", "unicode"].iter().any(|word| words.contains(word)) {
        let found = "a backslash in a string with \" begins an escape".to_owned();
        return Some((column, found, "/ between the parts of a path, or the string in '...'".to_owned()));
    }
    if text.starts_with('[') {
        let closing = if text.starts_with("[[") { "]]" } else { "]" };
        return (!text.contains(closing))
            .then(|| (start, "the name of a table without its end".to_owned(), format!("{text}{closing}")));
    }
    values(line).into_iter().find_map(value_fault).or_else(|| key_fault(line, start))
}

/// A value and the text after its comma.
struct Written<'l> {
    at: usize,
    text: &'l str,
    next: &'l str,
}

/// The text after each `=` of a line, up to the end of the value, unless a string is left open.
fn values(line: &str) -> Vec<Written<'_>> {
    let mut found = Vec::new();
    let mut quote = None;
    for (at, sign) in line.char_indices() {
        match (sign, quote) {
            ('"' | '\'', None) => quote = Some(sign),
            (_, Some(open)) if open == sign => quote = None,
            ('#', None) => break,
            ('=', None) => {
                let rest = &line[at + 1..];
                let text = rest.trim_start();
                let end = text.find([',', '}', ']', '#']).unwrap_or(text.len());
                let next = text[end..].strip_prefix(',').unwrap_or_default();
                let next = next[..next.find([',', '}', ']', '#']).unwrap_or(next.len())].trim_end();
                found.push(Written { at: line.len() - text.len(), text: text[..end].trim_end(), next });
            }
            _ => {}
        }
    }
    found
}

fn value_fault(Written { at, text, next }: Written<'_>) -> Option<Fault> {
    let plain = text.trim_end_matches(';').trim_end();
    let found = |what: &str| format!("{} is {what}", shown(text));
    let (found, instead) = match () {
        () if text.is_empty() => ("the key has no value".to_owned(), "a value after `=`".to_owned()),
        () if is_number(text) && is_digits(next) => {
            (format!("`{text},{next}` has a decimal comma"), format!("{text}.{next}"))
        }
        () if plain.len() < text.len() => (format!("`;` after {}", shown(plain)), plain.to_owned()),
        () if text.starts_with(['"', '\'']) => {
            let quote = &text[..1];
            let is_open = text.matches(quote).count() == 1;
            return is_open.then(|| (at, "a string without its end".to_owned(), format!("{text}{quote}")));
        }
        () if ["true", "false"].iter().any(|word| word.eq_ignore_ascii_case(text) && *word != text) => {
            (found("no word of TOML"), text.to_ascii_lowercase())
        }
        () if text.starts_with(|c: char| c.is_ascii_alphabetic())
            && !["true", "false", "inf", "nan"].contains(&text) =>
        {
            (found("a word without quotes"), format!("\"{text}\""))
        }
        () => number_fault(text).map(|(what, instead)| (found(what), instead))?,
    };
    Some((at, found, instead))
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// What a wrong number is, and what to write instead.
fn number_fault(text: &str) -> Option<(&'static str, String)> {
    let (number, unit) = text.split_at(text.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(text.len()));
    let number = number.trim_end();
    Some(match () {
        () if !unit.is_empty() && is_number(number) && !is_number(text) => match unit {
            "s" | "ms" | "us" | "ns" => ("a time without quotes", format!("\"{text}\"")),
            _ => ("a number with a unit", number.to_owned()),
        },
        () if text.matches('.').count() > 1
            && let Some(number) = grouped(text, '.') =>
        {
            ("a number with several points", number)
        }
        () if text.starts_with('.') && is_number(text) => ("a number that begins with a point", format!("0{text}")),
        () if text.ends_with('.') && is_number(text) => ("a number that ends with a point", format!("{text}0")),
        () if text.len() > 1 && text.starts_with('0') && is_digits(text) => {
            ("a number that begins with 0", text.trim_start_matches('0').to_owned())
        }
        () => return None,
    })
}

/// The fault in the key of a line.
fn key_fault(line: &str, start: usize) -> Option<Fault> {
    let (key, value) = line.split_once('=').unwrap_or((line, ""));
    let key = key.trim();
    let is_plain = key.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"._[]".contains(&byte));
    if let Some(bracket) = key.find('[').filter(|_| is_plain) {
        let table = key[..bracket].rsplit('.').next().unwrap_or_default();
        let found = format!("{} has an index, which no key of TOML has", shown(key));
        return Some((start, found, format!("{table} = [{{ ... }}], or [[...{table}]] for each")));
    }
    if let Some((name, rest)) = key.split_once(':') {
        let value = if rest.is_empty() { value } else { rest };
        let (name, value) = (name.trim(), value.trim());
        return Some((start, "`:` stands where `=` belongs".to_owned(), format!("{name} = {value}")));
    }
    let (name, value) = key.split_once([' ', '\t']).filter(|_| value.is_empty())?;
    Some((start, "between key and value there is no `=`".to_owned(), format!("{name} = {}", value.trim())))
}
