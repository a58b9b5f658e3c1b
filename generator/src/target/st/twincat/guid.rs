//! GUIDs of TwinCAT's objects, each derived from a name: the same object has the same GUID in every run.

use crate::digest::digest;

/// The GUID of an object of some kind.
#[must_use]
pub fn of(kind: &str, name: &str) -> String {
    let digits = digest(format!("axgen {kind} {name}").as_bytes());
    // RFC 9562: version 8, its meaning is the tool's own; variant 10.
    let variant = match &digits[16..17] {
        "0" | "4" | "8" | "c" => "8",
        "1" | "5" | "9" | "d" => "9",
        "2" | "6" | "a" | "e" => "a",
        _ => "b",
    };
    format!(
        "{{{}-{}-8{}-{variant}{}-{}}}",
        &digits[..8],
        &digits[8..12],
        &digits[13..16],
        &digits[17..20],
        &digits[20..]
    )
}
