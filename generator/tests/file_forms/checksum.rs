//! The digest in every file: it is right, any change of the file is noticed, other line ends are none.

use super::CASES;
use generator::digest::{NO_CHECKSUM, digest, has_right_checksum};

/// Changed bytes of every file form.
const CHANGES: usize = 200;

/// Where the digest stands.
fn digest_at(text: &str) -> std::ops::Range<usize> {
    let line = text.find("checksum ").map(|at| at + "checksum ".len()).unwrap();
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
            assert_eq!(has_right_checksum(text), Some(true), "{}: {name}", case.name);
            let stated = &text[digest_at(text)];
            assert_eq!(text.matches(stated).count(), 1, "{}: {name}", case.name);
            assert!(!text.contains(NO_CHECKSUM), "{}: {name}: a checksum that nobody filled in", case.name);
        }
    }
}

#[test]
fn other_line_ends_leave_the_checksum_right() {
    for case in CASES.iter() {
        for (name, text) in &case.files {
            assert_eq!(has_right_checksum(&text.replace('\n', "\r\n")), Some(true), "{}: {name}", case.name);
        }
    }
}

/// Places from a digest of the file itself: the same in every run.
#[test]
fn any_changed_byte_makes_the_checksum_wrong() {
    let example = &CASES[0];
    let mut forms = std::collections::BTreeSet::new();
    for (name, text) in &example.files {
        let form = name.rsplit_once('.').unwrap().1;
        if !forms.insert(form) {
            continue;
        }
        let digits = digest_at(text);
        let mut changes = 0;
        for number in 0.. {
            let random = u64::from_str_radix(&digest(format!("{name} {number}").as_bytes())[..16], 16).unwrap();
            let at = usize::try_from(random % u64::try_from(text.len()).unwrap()).unwrap();
            if digits.contains(&at) || !text.is_char_boundary(at) || !text.as_bytes()[at].is_ascii() {
                continue;
            }
            let was = text.as_bytes()[at];
            let other = if was == b'#' { "+" } else { "#" };
            let mut changed = text.clone();
            changed.replace_range(at..=at, other);
            // Where the word before the digest is changed, there is no checksum left.
            let place = digits.start - text[..digits.start].rfind('\n').unwrap();
            let is_line = (digits.start - place..=digits.end).contains(&at);
            let found = has_right_checksum(&changed);
            assert!(found == Some(false) || is_line && found.is_none(), "{name}, byte {at}: {found:?}");
            changes += 1;
            if changes == CHANGES {
                break;
            }
        }
    }
    assert_eq!(forms.len(), 11, "{forms:?}");
}

#[test]
fn a_digest_that_is_changed_is_wrong() {
    for (name, text) in &CASES[0].files {
        let place = digest_at(text);
        for at in place {
            let mut changed = text.clone();
            let other = if &text[at..=at] == "0" { "1" } else { "0" };
            changed.replace_range(at..=at, other);
            assert_eq!(has_right_checksum(&changed), Some(false), "{name}");
        }
    }
}
