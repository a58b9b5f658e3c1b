//! The unit of an axis in texts with two units: um for a translatory axis, 0.001 deg for a rotary axis or a spindle.

use std::borrow::Cow;

/// The text with the axis's unit: `um/s or 0.001 deg/s` becomes one of the two.
pub(super) fn of_axis(text: &str, is_rotary: bool) -> Cow<'_, str> {
    // Most texts contain no unit, or only one; `contains` finds that sooner than `find`.
    if !text.contains(BETWEEN) {
        return text.into();
    }
    let (mut text_of_axis, mut rest) = (String::with_capacity(text.len()), text);
    while let Some(at) = rest.find(BETWEEN) {
        let (before, after) = (&rest[..at], &rest[at + BETWEEN.len()..]);
        // The text after both units: `/s`, `/s^2`.
        let power = after.find(|c: char| !"/s^0123456789".contains(c)).map_or(after, |end| &after[..end]);
        let translatory = format!("um{power}");
        match before.strip_suffix(&translatory) {
            Some(before) if is_rotary => text_of_axis.extend([before, "0.001 deg", power]),
            _ => text_of_axis.push_str(before),
        }
        rest = &after[power.len()..];
    }
    text_of_axis.push_str(rest);
    text_of_axis.into()
}

/// The text between the two units.
const BETWEEN: &str = " or 0.001 deg";
