//! Transcripts: data files of inputs, each with what is reported for it. No subject of a test.
//!
//! ```text
//! A line before the first `==` says what the file is about.
//!
//! == form: title
//! # A remark.
//! > one line of an input
//! > its next line; `\u{e4}` is a character that an editor might lose
//! one line of what is reported
//!
//! > the next input, for which nothing is reported
//! ```
//!
//! An input may also follow the line before at once: a sequence reads as a dialogue.
//!
//! The form says how the test completes the input. `UPDATE_EXPECT=1 cargo test` writes what is reported into the files.
#![forbid(unsafe_code)]

use std::path::Path;

/// Compares a file with the same inputs and what `say` reports for each of them, given its form and the input.
///
/// # Panics
///
/// Where they differ, or the file holds no input.
pub fn compare(path: impl AsRef<Path>, say: impl FnMut(&str, &str) -> String) {
    let path = path.as_ref();
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let current = current(&text, say);
    assert!(text.lines().any(|line| line.starts_with('>')), "{}: no input", path.display());
    equals(path, &current);
}

/// Compares a file with a text.
///
/// # Panics
///
/// Where they differ.
pub fn equals(path: impl AsRef<Path>, text: &str) {
    expect_test::expect_file![path.as_ref()].assert_eq(text);
}

/// The file as it should be.
fn current(text: &str, mut say: impl FnMut(&str, &str) -> String) -> String {
    let mut current = String::new();
    let mut form = "";
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        current.push_str(line);
        current.push('\n');
        if let Some(heading) = line.strip_prefix("== ") {
            form = heading.split_once(':').unwrap_or_else(|| panic!("no form: {line}")).0;
        }
        let Some(first) = given(line) else { continue };
        let mut input = vec![first];
        while let Some((line, next)) = lines.peek().and_then(|line| given(line).map(|next| (*line, next))) {
            current.push_str(line);
            current.push('\n');
            input.push(next);
            lines.next();
        }
        for line in say(form, &input.join("\n")).lines() {
            current.push_str(line);
            current.push('\n');
        }
        while lines.next_if(|line| !line.is_empty() && !line.starts_with('>')).is_some() {}
    }
    current
}

/// What a line of an input holds.
fn given(line: &str) -> Option<String> {
    let line = line.strip_prefix('>')?;
    let mut parts = line.strip_prefix(' ').unwrap_or(line).split(r"\u{");
    let mut whole = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (code, rest) = part.split_once('}').unwrap_or_else(|| panic!("no end of a character: {line}"));
        let sign = u32::from_str_radix(code, 16).ok().and_then(char::from_u32);
        whole.push(sign.unwrap_or_else(|| panic!("no character: {line}")));
        whole.push_str(rest);
    }
    Some(whole)
}
