//! The digest in every file: it is right, any change of the file is noticed, other line ends are none.

use crate::CASES;
use generator::digest::{digest, is_sealed};

/// Changed bytes of every file form.
const CHANGES: usize = 200;

/// Where the digest stands.
fn digest_at(text: &str) -> std::ops::Range<usize> {
    let line = text.find("body ").map(|at| at + "body ".len()).unwrap();
    let start = line + text[line..].find(|c: char| c != ' ').unwrap();
    let digits = &text[start..start + 32];
    assert!(digits.bytes().all(|digit| matches!(digit, b'0'..=b'9' | b'a'..=b'f')), "{digits}");
    assert!(text[start + 32..].starts_with('\n'));
    start..start + 32
}

#[test]
fn every_file_bears_its_digest_once() {
    for case in CASES.iter() {
        for (name, text) in &case.files {
            assert_eq!(is_sealed(text), Some(true), "{}: {name}", case.name);
            let stated = &text[digest_at(text)];
            assert_eq!(text.matches(stated).count(), 1, "{}: {name}", case.name);
        }
    }
}

#[test]
fn other_line_ends_break_no_seal() {
    for case in CASES.iter() {
        for (name, text) in &case.files {
            assert_eq!(is_sealed(&text.replace('\n', "\r\n")), Some(true), "{}: {name}", case.name);
        }
    }
}

/// Places from a digest of the file itself: the same in every run.
#[test]
fn any_changed_byte_breaks_the_seal() {
    let example = &CASES[0];
    let mut forms = std::collections::BTreeSet::new();
    for (name, text) in &example.files {
        let form = name.rsplit_once('.').unwrap().1;
        if !forms.insert(form) {
            continue;
        }
        let sealed = digest_at(text);
        let mut changes = 0;
        for number in 0.. {
            let random = u64::from_str_radix(&digest(format!("{name} {number}").as_bytes())[..16], 16).unwrap();
            let at = usize::try_from(random % u64::try_from(text.len()).unwrap()).unwrap();
            if sealed.contains(&at) || !text.is_char_boundary(at) || !text.as_bytes()[at].is_ascii() {
                continue;
            }
            let was = text.as_bytes()[at];
            let other = if was == b'#' { "+" } else { "#" };
            let mut changed = text.clone();
            changed.replace_range(at..=at, other);
            // Where the word before the digest is changed, there is no seal left.
            let place = sealed.start - text[..sealed.start].rfind('\n').unwrap();
            let is_line = (sealed.start - place..=sealed.end).contains(&at);
            let found = is_sealed(&changed);
            assert!(found == Some(false) || is_line && found.is_none(), "{name}, byte {at}: {found:?}");
            changes += 1;
            if changes == CHANGES {
                break;
            }
        }
    }
    assert_eq!(forms.len(), 10, "{forms:?}");
}

#[test]
fn a_digest_that_is_changed_is_wrong() {
    for (name, text) in &CASES[0].files {
        let place = digest_at(text);
        for at in place {
            let mut changed = text.clone();
            let other = if &text[at..=at] == "0" { "1" } else { "0" };
            changed.replace_range(at..=at, other);
            assert_eq!(is_sealed(&changed), Some(false), "{name}");
        }
    }
}
