//! From a path as written (`stage[0].filter.order`) to the parameter and its indices; no value and no message is here.

use crate::parameters::{Name, Scope, TABLE};
use std::collections::HashMap;
use std::sync::LazyLock;

/// What a path names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Path {
    /// a parameter of the table
    Known {
        /// which one
        name: Name,
        /// its indices
        index: [u32; 2],
        /// the template that it was found by
        spelling: &'static str,
        /// whether it is a manual's misprint
        misprint: bool,
    },
    /// a parameter of the table with an index that does not exist
    OutOfRange {
        /// which one
        name: Name,
        /// the template that it was found by
        spelling: &'static str,
    },
    /// well-formed, not in the table
    Foreign,
    /// no path at all
    Malformed,
}

/// The longest template has 68 bytes; what is longer is foreign.
const LONGEST: usize = 128;

struct Spelling {
    name: Name,
    template: &'static str,
    misprint: bool,
}

/// Every spelling of every parameter, with `[]` for an index.
static SPELLINGS: LazyLock<HashMap<Vec<u8>, Spelling>> = LazyLock::new(|| {
    let mut spellings = HashMap::new();
    for name in Name::ALL {
        let parameter = name.parameter();
        let proper = std::iter::once(&parameter.path).chain(parameter.aliases).map(|template| (template, false));
        for (template, misprint) in proper.chain(parameter.misprints.iter().map(|template| (template, true))) {
            spellings.insert(without_indices(template).into_bytes(), Spelling { name, template, misprint });
        }
    }
    spellings
});

/// Every prefix of a path below an axis that ends before a point: the structures of a set's tables, with `[]` for an
/// index.
static STRUCTURES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let mut structures: Vec<String> = templates()
        .flat_map(|template| {
            let path = without_indices(template);
            path.match_indices('.').map(|(at, _)| path[..at].to_owned()).collect::<Vec<_>>()
        })
        .collect();
    structures.sort_unstable();
    structures.dedup();
    structures
});

/// Every path and alias without its indices, in small letters: `getriebe.kv`. The first of equals is a path.
static BARE: LazyLock<HashMap<Vec<u8>, &'static str>> = LazyLock::new(|| {
    let vendors = Name::ALL.map(Name::parameter).into_iter().filter(|parameter| parameter.scope == Scope::List);
    let mut bare = HashMap::new();
    for template in vendors.flat_map(|parameter| std::iter::once(&parameter.path).chain(parameter.aliases)) {
        bare.entry(without_brackets(template, &mut [0; LONGEST]).to_vec()).or_insert(*template);
    }
    bare
});

/// The template that a path would name with other indices, in other letters: `getriebe[i].kv` for `getriebe.kv`.
#[must_use]
pub fn with_other_indices(path: &str) -> Option<&'static str> {
    if path.len() > LONGEST { None } else { BARE.get(without_brackets(path, &mut [0; LONGEST])).copied() }
}

/// Without allocating: a real machine's list has hundreds of paths to ask for.
fn without_brackets<'b>(path: &str, bare: &'b mut [u8; LONGEST]) -> &'b [u8] {
    let mut length = 0;
    let mut within = false;
    for byte in path.bytes() {
        within = within || byte == b'[';
        if let Some(place) = bare.get_mut(length).filter(|_| !within) {
            *place = byte.to_ascii_lowercase();
            length += 1;
        }
        within = within && byte != b']';
    }
    &bare[..length]
}

/// Finds what a path names.
#[must_use]
pub fn find(path: &str) -> Path {
    let mut plain = [0; LONGEST];
    let mut length = 0;
    let mut index = [0; 2];
    let mut indices = 0;
    let mut put = |byte: u8| {
        if let Some(place) = plain.get_mut(length) {
            *place = byte;
        }
        length += 1;
    };
    let bytes = path.as_bytes();
    let mut at = 0;
    let mut before = b'.';
    while let Some(&byte) = bytes.get(at) {
        at += 1;
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'_' => put(byte),
            b'.' if before != b'.' => put(byte),
            b'[' if before != b'.' => {
                let digits = bytes[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
                // Empty brackets mean 0; an index beyond u32 exists in no structure.
                let number = if digits == 0 { 0 } else { path[at..at + digits].parse().unwrap_or(u32::MAX) };
                at += digits;
                if bytes.get(at) != Some(&b']') {
                    return Path::Malformed;
                }
                at += 1;
                if let Some(place) = index.get_mut(indices) {
                    *place = number;
                }
                indices += 1;
                put(b'[');
                put(b']');
            }
            _ => return Path::Malformed,
        }
        before = byte;
    }
    if before == b'.' || bytes[0].is_ascii_digit() {
        return Path::Malformed;
    }
    let Some(&Spelling { name, template, misprint }) = plain.get(..length).and_then(|plain| SPELLINGS.get(plain))
    else {
        return Path::Foreign;
    };
    let within = name.parameter().indices.iter().zip(index).all(|(size, index)| index < *size);
    if within {
        Path::Known { name, index, spelling: template, misprint }
    } else {
        Path::OutOfRange { name, spelling: template }
    }
}

/// Whether parameters stand below this path in a set: `lr_param`, `lr_param.improved_position_control.stage[0]`.
#[must_use]
pub fn is_structure(path: &str) -> bool {
    let plain = without_indices(path);
    STRUCTURES.binary_search(&plain).is_ok()
}

/// All structures, with `[]` for an index.
pub fn structures() -> impl Iterator<Item = &'static str> {
    STRUCTURES.iter().map(String::as_str)
}

/// All templates that may stand below an axis.
pub fn templates() -> impl Iterator<Item = &'static str> {
    let below_an_axis = TABLE.iter().filter(|parameter| parameter.scope != Scope::Set);
    below_an_axis.flat_map(|parameter| std::iter::once(&parameter.path).chain(parameter.aliases)).copied()
}

/// `stage[0].mode` and `stage[i].mode` as `stage[].mode`.
#[must_use]
pub fn without_indices(path: &str) -> String {
    let mut plain = String::with_capacity(path.len());
    let mut within = false;
    for character in path.chars() {
        within = within && character != ']';
        if !within {
            plain.push(character);
        }
        within = within || character == '[';
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(path: &str) -> (Name, [u32; 2], bool) {
        match find(path) {
            Path::Known { name, index, misprint, .. } => (name, index, misprint),
            other => panic!("{path}: {other:?}"),
        }
    }

    #[test]
    fn indices_aliases_and_misprints() {
        let ipc = "lr_param.improved_position_control";
        assert_eq!(known(&format!("{ipc}.stage[2].filter[1].fg_f0")), (Name::FilterF0, [2, 1], false));
        assert_eq!(known(&format!("{ipc}.stage[].filter[].fg_f0")), (Name::FilterF0, [0, 0], false));
        assert_eq!(known(&format!("{ipc}.stage[1].filter.fg_f0")), (Name::FilterF0, [1, 0], false));
        assert_eq!(known(&format!("{ipc}.stage[1]osc_damping")), (Name::OscDamping, [1, 0], true));
        assert_eq!(known(&format!("{ipc}.stage[1].filter[0].damping")), (Name::FilterDamping, [1, 0], false));
        assert_eq!(known("getriebe[15].dynamik.vb_max"), (Name::VbMax, [15, 0], false));
    }

    #[test]
    fn other_indices() {
        assert_eq!(with_other_indices("getriebe.kv"), Some("getriebe[i].kv"));
        assert_eq!(with_other_indices("Vorsteuer[0].VORSTEUERUNG"), Some("vorsteuer.vorsteuerung"));
        assert_eq!(with_other_indices("kopf[0].achs_nr[3]"), Some("kopf.achs_nr"));
        assert_eq!(with_other_indices("kenngr.swe_pos"), None);
    }

    #[test]
    fn what_does_not_exist() {
        assert!(matches!(find("getriebe[16].dynamik.vb_max"), Path::OutOfRange { name: Name::VbMax, .. }));
        assert!(matches!(find("getriebe[99999999999].dynamik.vb_max"), Path::OutOfRange { .. }));
        assert_eq!(find("kenngr.swe_pos"), Path::Foreign);
        assert_eq!(find(&"x".repeat(1000)), Path::Foreign);
        for malformed in
            ["", ".", "a.", ".a", "a..b", "a[", "a[x]", "a[1", "[1]", "a[0][", "1a", "a=1", "a-b", "a[[0]]", "ä"]
        {
            assert_eq!(find(malformed), Path::Malformed, "{malformed}");
        }
    }

    #[test]
    fn structures_of_a_set() {
        for path in ["lr_param", "lr_param.improved_position_control.stage[2]", "getriebe[1].dynamik"] {
            assert!(is_structure(path), "{path}");
        }
        for path in ["lr", "getriebe", "lr_param.improved_position_control.enable", ""] {
            assert!(!is_structure(path), "{path}");
        }
    }

    #[test]
    fn no_spelling_belongs_to_two_parameters() {
        let all: usize = TABLE.iter().map(|p| 1 + p.aliases.len() + p.misprints.len()).sum();
        assert_eq!(SPELLINGS.len(), all);
        assert!(SPELLINGS.keys().all(|spelling| spelling.len() < LONGEST));
    }
}
