//! Names that C and Structured Text can use unchanged.

use crate::reject::Rejections;
use syn::Ident;

/// Rejects a name that another language cannot use.
pub fn check(name: &Ident, rejections: &mut Rejections) {
    let text = name.to_string();
    if text.starts_with("r#") {
        rejections.push(name, "a keyword is not a name in the emitted code; write another name");
    } else if !text.is_ascii() {
        rejections.push(name, "names in C and Structured Text are ASCII; write another name");
    }
}
