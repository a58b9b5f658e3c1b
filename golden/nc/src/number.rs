//! Numbers as they are written: which forms are read, and what they are. No letter that stands before them.

/// What a message says of a decimal number.
pub(crate) const DECIMAL: &str =
    "a number like `5`, `-5` or `0.5`, with up to 9 digits before the point and up to 6 behind it";
/// What a message says of an integer.
pub(crate) const INTEGER: &str = "an integer like `80`, with up to 9 digits";

/// `d`, `+d`, `-d`, `d.d`: 15 digits are exact enough for a double to be written back as they were.
pub(crate) fn decimal(text: &str) -> Option<f64> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (whole, part) = unsigned.split_once('.').map_or((unsigned, None), |(whole, part)| (whole, Some(part)));
    if !digits(whole, 9) || part.is_some_and(|part| !digits(part, 6)) {
        return None;
    }
    // No number is -0: nothing may depend on how a zero was written.
    text.parse().ok().map(|value: f64| value + 0.0)
}

/// `d`, `+d`, `-d`
pub(crate) fn integer(text: &str) -> Option<i32> {
    digits(text.strip_prefix(['+', '-']).unwrap_or(text), 9).then(|| text.parse().ok()).flatten()
}

/// `d`
pub(crate) fn count(text: &str) -> Option<u32> {
    digits(text, 9).then(|| text.parse().ok()).flatten()
}

fn digits(text: &str, most: usize) -> bool {
    (1..=most).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit())
}
