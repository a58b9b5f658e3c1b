//! Another value of one parameter in the text of an axis: a TOML set or an axis list. All other bytes stay. Whether the value is
//! allowed is not judged here.

use crate::codes;
use crate::config::{ListOptions, Load, Setting, given};
use crate::diagnostics::{Diagnostic, Place, Report, Slashes};
use crate::parameters::{Name, path_with};
use std::path::{Path, PathBuf};

/// The file that contains the value of a parameter of an axis, with another value.
///
/// # Errors
/// The file cannot be read, or does not contain the parameter in a form that is edited.
pub fn with_value(
    path: &Path,
    options: &ListOptions,
    (axis, key): (&str, (Name, [u32; 2])),
    value: &str,
    load: Load<'_>,
) -> Result<(PathBuf, Vec<u8>), Report> {
    let given = given::read(path, options, load)?;
    let values = given.axes.iter().find(|of| of.name == axis).and_then(|of| of.values.as_ref());
    let refused = |found: String| -> Report {
        let said = Diagnostic::error(codes::NOT_WRITTEN, Place::whole(path.slashes()), found);
        said.instead(format!("{} {value}", path_with(key.0.parameter().path, key.1))).into()
    };
    let setting = values.and_then(|values| values.get(key));
    let setting = setting.ok_or_else(|| refused(format!("the axis {axis} does not give this parameter")))?;
    let (source, at) = (&setting.source, setting.value_at);
    if source.is_option() || source.is_converted() {
        return Err(refused(format!("the axis {axis} gives this parameter in a form that is not edited")));
    }
    let length = length(setting);
    let text = [&source.bytes[..at], value.as_bytes(), &source.bytes[at + length..]].concat();
    let bytes = source.encoding.encoded(text).map_err(|found| refused(format!("its encoding lacks {found:?}")))?;
    Ok((PathBuf::from(&source.name), bytes))
}

/// The length of a number, or of a word, in the file.
fn length(setting: &Setting) -> usize {
    let is_part = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-._".contains(byte);
    setting.source.bytes[setting.value_at..].iter().take_while(|byte| is_part(byte)).count()
}
