//! Allowed names of an axis, and the name from a file or a project. Nothing is looked up here.

use std::path::Path;

/// With the additions of a target, the name of a type or a function has at most 63 characters, which every compiler
/// distinguishes.
const LONGEST: usize = 32;

pub(crate) const ALLOWED: &str =
    "1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)";

/// Whether C and Structured Text both accept the name.
pub(crate) fn is_allowed(name: &str) -> bool {
    let characters = name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let ends = name.starts_with(|c: char| c.is_ascii_alphabetic()) && !name.ends_with('_');
    characters && ends && !name.contains("__") && name.len() <= LONGEST
}

/// The name from a name in a project, of which the first characters that an axis may have; `None` if none is left.
pub(crate) fn of_tree_item(words: &str) -> Option<String> {
    let name = of_words(words);
    let name = name[..name.len().min(LONGEST)].trim_end_matches('_');
    is_allowed(name).then(|| name.to_owned())
}

/// The name from the stem of a file's name.
pub(crate) fn of_file(path: &Path) -> String {
    of_words(&path.file_stem().unwrap_or_default().to_string_lossy())
}

/// A name from any words: a character that is not allowed becomes an underscore; `axis_` is put before a digit.
pub(crate) fn of_words(words: &str) -> String {
    let words: Vec<&str> = words.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    let name = words.join("_");
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("axis_{name}") } else { name }
}
