//! What things are called in C. No text is put together here.

use std::collections::BTreeSet;

/// Words that C, C++ and the two headers that a block includes keep for themselves.
const RESERVED: &[&str] = &[
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "class",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "co_await",
    "co_return",
    "co_yield",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "int32_t",
    "int64_t",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "uint32_t",
    "uint64_t",
    "union",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    "state",
    "inputs",
    "outputs",
    "bits_of",
    "real_of",
    "fold",
    "digest",
    "scale",
    "step",
    "noise",
    "random",
    "sample",
    "magnitude",
];

/// The identifier of a path: `stage[0].filter[1].y` becomes `stage0_filter1_y`.
#[must_use]
pub fn identifier(path: &str) -> String {
    let mut name = String::with_capacity(path.len());
    for character in path.chars() {
        match character {
            '[' | ']' => {}
            '.' => name.push('_'),
            other => name.push(other),
        }
    }
    name
}

/// Whether C keeps the word for itself, or a block uses it.
#[must_use]
pub fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name)
}

/// The names of one file, each given once.
#[derive(Default)]
pub struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// A name for what stands at the path, unlike every name given before.
    pub fn take(&mut self, path: &str) -> String {
        let plain = identifier(path);
        let mut name = if is_reserved(&plain) { format!("{plain}_value") } else { plain.clone() };
        let mut number = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{plain}_{number}");
            number += 1;
        }
        name
    }
}
