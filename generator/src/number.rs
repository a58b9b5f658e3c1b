//! Numbers as text for readers: short, the same on every host, and different for two different numbers.

/// `old -> new`, both with at least `digits` significant digits and as many more as distinguish them.
pub(crate) fn pair(old: f64, new: f64, digits: usize) -> String {
    let text = |digits| [old, new].map(|value| significant(value, digits));
    let apart = (digits..17).map(text).find(|[a, b]| a != b).unwrap_or_else(|| text(digits));
    apart.join(" -> ")
}

/// As many zeros as a number without exponent may have.
const ZEROS: &str = "00000000000";

/// A number with N significant digits, no trailing zeros.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    // If the shortest digits are not more, they are these digits; most numbers are short, and the shortest are found sooner.
    let shortest = format!("{value:e}");
    let is_short = shortest.bytes().take_while(|byte| *byte != b'e').filter(u8::is_ascii_digit).count() <= digits;
    let text = if is_short { shortest } else { format!("{value:.*e}", digits.saturating_sub(1)) };
    let Some((mantissa, exponent)) = text.split_once('e') else { return text };
    let has_zeros = !is_short && digits > 1;
    let mantissa = if has_zeros { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    let power: i32 = exponent.parse().expect("number: an exponent is a number");
    if !(-4..12).contains(&power) {
        return [mantissa, "e", exponent].concat();
    }
    let (sign, mantissa) = mantissa.split_at(usize::from(value.is_sign_negative()));
    let (first, rest) = mantissa.split_at(1);
    let rest = rest.strip_prefix('.').unwrap_or(rest);
    match usize::try_from(power) {
        Ok(whole) if whole < rest.len() => [sign, first, &rest[..whole], ".", &rest[whole..]].concat(),
        Ok(whole) => [sign, first, rest, &ZEROS[..whole - rest.len()]].concat(),
        Err(_) => [sign, "0.", &ZEROS[..power.unsigned_abs() as usize - 1], first, rest].concat(),
    }
}

/// A number with at most N decimals, no trailing zeros, no -0.
pub(crate) fn decimals(value: f64, decimals: usize) -> String {
    let rounded: f64 = format!("{value:.decimals$}").parse().expect("number: a formatted number is a number");
    format!("{}", rounded + 0.0)
}

/// A change in per cent with its sign: ` (-1.9 %)`.
pub(crate) fn percent(old: f64, new: f64) -> String {
    let part = (new - old) / old * 100.0;
    let sign = if part > 0.0 { "+" } else { "" };
    let text = if part.abs() < 0.05 { significant(part, 2) } else { decimals(part, 1) };
    format!(" ({sign}{text} %)")
}

/// A factor in decibels: 20 log10(factor).
pub(crate) fn decibels(factor: f64) -> f64 {
    20.0 * libm::log10(factor)
}

/// Seven significant digits, no trailing zeros, the same on every host.
pub(crate) fn digits(value: f64) -> String {
    significant(value, 7)
}

/// Six significant digits, for a message.
pub(crate) fn rounded(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

/// Rounded down to N significant digits, for an upper limit.
pub(crate) fn down_to(value: f64, digits: i32) -> String {
    if value <= 0.0 {
        return "0".to_owned();
    }
    let unit = libm::pow(10.0, libm::floor(libm::log10(value)) + 1.0 - f64::from(digits));
    // 0.3 is not a multiple of 0.1 in binary.
    significant(libm::floor(value / unit + 1e-9) * unit, digits.unsigned_abs() as usize)
}
