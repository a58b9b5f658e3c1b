//! The text of a value in a list, and its text in TOML, with the same spelling if both allow it.

use crate::config::{of_text, of_toml, own_key, spelled};
use crate::parameters::{Name, Parameter, Value};
use toml::de::DeValue;

/// The value of a list as TOML: in its own spelling if TOML reads that as the same value, else in the canonical form.
pub(super) fn in_toml(parameter: &Parameter, text: &str, value: &Value) -> toml_edit::Value {
    let canonical = value.text();
    let forms = |text: &str| {
        let bare = Some(text).filter(|text| is_bare(text)).and_then(|text| text.parse().ok());
        let words = text.split_ascii_whitespace().collect();
        bare.into_iter().chain([toml_edit::Value::from(text), words])
    };
    let is_same = |form: &toml_edit::Value| {
        DeValue::parse(&form.to_string()).is_ok_and(|form| of_toml(parameter, &form).as_ref() == Ok(value))
    };
    forms(text).chain(forms(&canonical)).find(is_same).unwrap_or_else(|| canonical.as_str().into())
}

/// The value that begins these bytes of a set, for a list: in its own spelling if a list reads that as the same value, else
/// in the canonical form; for a comment, if it is one of axgen's own keys.
pub(super) fn in_list(name: Name, toml: &[u8], value: &Value) -> String {
    let spelled = match toml.first() {
        Some(quote @ (b'"' | b'\'')) => toml[1..].split(|byte| byte == quote).next().unwrap_or_default(),
        _ => toml.split(|byte| !byte.is_ascii_alphanumeric() && !b"+-._".contains(byte)).next().unwrap_or_default(),
    };
    let plain = spelled.iter().all(|byte| byte.is_ascii_graphic() && !b"#(\\".contains(byte));
    let spelled = match str::from_utf8(spelled).unwrap_or_default() {
        "true" => "TRUE",
        "false" => "FALSE",
        other => other,
    };
    let same = plain && !spelled.is_empty() && of_text(name.parameter(), spelled).as_ref() == Ok(value);
    let text = if same { spelled.to_owned() } else { value.text() };
    if own_key::is_own(name) { own_key::text_of(value, text) } else { text }
}

/// The text that a controller treats as a comment after a value, as a comment of TOML, with a blank after it.
pub(super) fn after(parameter: &Parameter, line: &str) -> String {
    let after = spelled(parameter, line).after;
    if after.is_empty() { String::new() } else { format!("# {after} ") }
}

/// Whether every reader of TOML reads the text as its value without quotes: some reject a number beyond 64 bits.
fn is_bare(text: &str) -> bool {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let is_whole = !unsigned.is_empty() && unsigned.bytes().all(|byte| byte.is_ascii_digit());
    !is_whole || text.parse::<i64>().is_ok()
}
