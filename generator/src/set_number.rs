//! One number of an axis in the user's own text: its digits are replaced where they stand, in a set or in a list that the set
//! names; all other bytes stay. Whether the number is allowed is not judged here, and no file is written.

use crate::codes;
use crate::config::{ListOptions, Load, file, given};
use crate::diagnostics::{Diagnostic, Report};
use crate::parameters::Name;
use std::path::{Path, PathBuf};

/// A file with another number.
#[derive(Clone, Debug)]
pub struct Changed {
    pub file: PathBuf,
    pub after: Vec<u8>,
}

/// The file of an axis with another value of the first of some parameters that is given; `None` if none is.
///
/// # Errors
/// The set cannot be read, or the value stands where it cannot be replaced.
pub fn set_number(
    (path, options, load): (&Path, &ListOptions, Load<'_>),
    axis: &str,
    (names, index): (&[Name], [u32; 2]),
    value: f64,
) -> Result<Option<Changed>, Report> {
    let given = given::read(path, options, load)?;
    let values = given.axes.iter().find(|of| of.name == axis).and_then(|of| of.values.as_ref());
    let setting = values.and_then(|values| names.iter().find_map(|name| values.get((*name, index))));
    let Some(setting) = setting else { return Ok(None) };
    let (source, at) = (&setting.source, setting.value_at);
    let refused = |found: &str| Diagnostic::error(codes::NOT_WRITTEN, setting.value_place(), found).into();
    let digits = source.bytes.get(at..).unwrap_or_default();
    let is_digit = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-._".contains(byte);
    let length = digits.iter().position(|byte| !is_digit(byte)).unwrap_or(digits.len());
    if source.is_option() || source.is_converted() || length == 0 {
        return Err(refused("the number is not written in a form that is edited"));
    }
    // A real number stays one in TOML, which distinguishes 53 and 53.0.
    let is_real = file::is_set(Path::new(&source.name)) && digits[..length].contains(&b'.');
    let text = if is_real { format!("{value:?}") } else { value.to_string() };
    let after = [&source.bytes[..at], text.as_bytes(), &digits[length..]].concat();
    let after = source.encoding.encoded(after).map_err(|_| refused("the encoding of the file lacks a character"))?;
    Ok(Some(Changed { file: PathBuf::from(&source.name), after }))
}
