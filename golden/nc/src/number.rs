//! The accepted forms of numbers, and their values. The letter before a number is not known here.

/// The description of a decimal number in a message.
pub(crate) const DECIMAL: &str =
    "a number like `5`, `-5`, `.5` or `5.`, with up to 9 digits before the point and up to 30 after it";
/// The description of an integer in a message.
pub(crate) const INTEGER: &str = "an integer like `80`, with up to 9 digits";

/// `d`, `d.`, `.d`, `d.d`, each with or without a sign.
pub(crate) fn decimal(text: &str) -> Option<f64> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (whole, part) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    let is_empty = whole.is_empty() && part.is_empty();
    if is_empty || !digits(whole, 9) || !digits(part, 30) {
        return None;
    }
    // Never -0: nothing may depend on the notation of a zero.
    text.parse().ok().map(|value: f64| value + 0.0)
}

/// `d`, `+d`, `-d`
pub(crate) fn integer(text: &str) -> Option<i32> {
    count(text.strip_prefix(['+', '-']).unwrap_or(text)).and(text.parse().ok())
}

/// `d`
pub(crate) fn count(text: &str) -> Option<u32> {
    (!text.is_empty() && digits(text, 9)).then(|| text.parse().ok()).flatten()
}

fn digits(text: &str, most: usize) -> bool {
    text.len() <= most && text.bytes().all(|byte| byte.is_ascii_digit())
}
