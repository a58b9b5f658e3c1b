//! Text of every file: comments that are closed and hold no other, and nothing of the machine on which it was made.

use super::{CASES, OBJECTS, xml};
use std::collections::BTreeSet;

/// All pieces of Structured Text of a file.
fn pieces(name: &str, text: &str) -> Vec<String> {
    fn collect(element: &xml::Element, names: &[&str], found: &mut Vec<String>) {
        if names.contains(&element.name.as_str()) {
            found.push(element.text.clone());
        }
        element.children.iter().for_each(|child| collect(child, names, found));
    }
    let mut found = Vec::new();
    if name.ends_with(".st") || name.ends_with(".scl") {
        found.push(text.to_owned());
    } else if OBJECTS.iter().any(|ending| name.ends_with(ending)) {
        collect(&xml::read(text).unwrap(), &["Declaration", "ST"], &mut found);
    } else if name.ends_with(".xml") {
        let root = xml::read(text).unwrap();
        for pou in root.at("types/pous").all("pou") {
            found.push(pou.at("body/ST/xhtml").text.clone());
        }
    }
    found
}

/// Characters in a line of a language at most: one comparison with a named number, deep inside, is not broken. XML
/// breaks no line.
const WIDTH: usize = 150;

#[test]
fn no_line_is_too_long() {
    for case in CASES.iter() {
        for (name, text) in case.with(&[".c", ".h", ".rs", ".st", ".scl", ".TcPOU", ".TcDUT"]) {
            let long = text.lines().find(|line| line.len() > WIDTH);
            assert_eq!(long, None, "{}: {name}", case.name);
        }
    }
}

/// docs/structured-text.md names the blocks that print CASE.
#[test]
fn blocks_with_case_are_those_that_the_document_names() {
    let page = include_str!("../../../docs/structured-text.md");
    let sentence = page.split("Blocks with CASE are ").nth(1).unwrap().split("\n\n").next().unwrap();
    let named: BTreeSet<&str> = sentence.split('`').skip(1).step_by(2).collect();
    let kinds = ["ipc", "feedforward", "position_control", "axis", "spindle", "spindle_axis", "set_design"];
    let mut found = BTreeSet::new();
    for case in CASES.iter() {
        for (name, text) in case.with(&[".st"]) {
            if !name.ends_with("_self_test.st") && text.contains("CASE ") {
                // The longest name that fits: `spindle_axis` ends like `axis`.
                let fits = kinds.iter().filter(|kind| name.ends_with(&format!("_{kind}.st")));
                found.insert(*fits.max_by_key(|kind| kind.len()).unwrap());
            }
        }
    }
    assert_eq!(found, named);
}

/// The names of a text, without comments and without those that an axis's number ends.
fn names(text: &str) -> BTreeSet<&str> {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
    words.filter(|word| !word.contains("axis_") && word.starts_with(|c: char| c.is_ascii_lowercase())).collect()
}

/// A number at the end of a name counts the values of that name, from 2 on.
#[test]
fn a_numbered_name_has_one_before_it() {
    let mut numbered = 0;
    for case in CASES.iter() {
        for (file, text) in case.with(&[".c", ".rs", ".st", ".scl", ".TcPOU"]) {
            let names = names(text);
            for name in &names {
                let Some((path, end)) = name.rsplit_once('_') else { continue };
                let Ok(number) = end.parse::<u32>() else { continue };
                // A number of SCL is named after its digits.
                if ["real", "lreal"].contains(&path) {
                    continue;
                }
                let before = if number == 2 { path.to_owned() } else { format!("{path}_{}", number.saturating_sub(1)) };
                // A reserved word has another name the first time.
                let is_known = [&*before, &format!("{before}_value")].iter().any(|before| names.contains(before));
                assert!(number > 1 && is_known, "{}: {file}: {name}", case.name);
                numbered += 1;
            }
        }
    }
    assert!(numbered > 100, "{numbered} names");
}

/// Names of the second value of something say nothing of time: the block keeps the values of the last cycle.
#[test]
fn no_name_says_when_it_is_valid() {
    let known = ["spindle_next", "next", "v_last"];
    for case in CASES.iter() {
        for (file, text) in case.with(&[".c", ".rs", ".st", ".scl", ".TcPOU"]) {
            let is_of_time = |name: &&&str| {
                ["_next", "_last", "_then", "_after", "_later", "_again"].iter().any(|end| name.ends_with(end))
                    && !known.iter().any(|known| name.ends_with(known))
            };
            let names = names(text);
            assert_eq!(names.iter().find(is_of_time), None, "{}: {file}", case.name);
        }
    }
}

/// The assignments in the statements of a file of Structured Text, without comments and breaks of lines.
fn assignments(text: &str) -> Vec<String> {
    let code = crate::without_comments(text);
    let is_name = |word: &str| word.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'_');
    let mut found = Vec::new();
    let mut lines = code.lines();
    while let Some(line) = lines.next() {
        let mut words = line.split_ascii_whitespace();
        // SCL marks the variables of a block.
        let target = words.next().map(|word| word.trim_start_matches('#'));
        if !(target.is_some_and(is_name) && words.next() == Some(":=")) {
            continue;
        }
        let mut statement = line.trim().to_owned();
        while !statement.ends_with(';') {
            statement.push_str(lines.next().unwrap().trim());
        }
        found.push(statement.split_ascii_whitespace().collect());
    }
    found
}

/// A state machine that says everything in every branch is not read by anybody.
#[test]
fn a_spindle_seldom_assigns_the_same_twice() {
    let mut count = 0;
    for case in CASES.iter() {
        for (name, text) in
            case.with(&["_spindle_axis.st", "_spindle_axis.scl", "_spindle_axis.xml", "_spindle_axis.TcPOU"])
        {
            let all = assignments(text);
            let distinct: BTreeSet<&String> = all.iter().collect();
            assert!(distinct.len() > 100, "{}: {name}: {} assignments", case.name, distinct.len());
            assert!(
                all.len() * 100 <= distinct.len() * 120,
                "{}: {name}: {} assignments, {} of them distinct",
                case.name,
                all.len(),
                distinct.len()
            );
            count += 1;
        }
    }
    assert!(count >= 20, "{count} spindles");
}

/// The head of each block says what it is for, and what happens while it is not called.
#[test]
fn every_block_says_what_it_is_for() {
    let mut count = 0;
    for case in CASES.iter() {
        for (name, text) in case.with(&[".h", ".rs", ".st", ".scl", ".TcPOU", ".xml"]) {
            if ["self_test", "_Test", "PRG_", "F_axgen", "axgen_", "rust/"].iter().any(|other| name.contains(other)) {
                continue;
            }
            let words: Vec<&str> =
                text.split_ascii_whitespace().filter(|word| !["*", "//", "//!"].contains(word)).collect();
            let head = words.join(" ");
            let says = ["While the block is not called, ", "v_add is 0 in every call"];
            assert!(says.iter().any(|said| head.contains(said)), "{}: {name}", case.name);
            count += 1;
        }
    }
    assert!(count > 100, "{count} blocks");
}

/// What is wrong with the comments of a piece.
fn fault(piece: &str) -> Option<&str> {
    let mut rest = piece;
    loop {
        let (code, inside) = match rest.split_once("(*") {
            None => return ["*)", "//"].into_iter().find(|mark| rest.contains(mark)),
            Some(parts) => parts,
        };
        if let Some(mark) = ["*)", "//"].into_iter().find(|mark| code.contains(mark)) {
            return Some(mark);
        }
        let Some((comment, after)) = inside.split_once("*)") else { return Some("not closed") };
        if comment.contains("(*") {
            return Some("(* in a comment");
        }
        rest = after;
    }
}

#[test]
fn every_comment_of_structured_text_is_closed_and_holds_no_other() {
    let mut count = 0;
    for case in CASES.iter() {
        for (name, text) in &case.files {
            for piece in pieces(name, text) {
                assert_eq!(fault(&piece), None, "{}: {name}", case.name);
                count += piece.matches("(*").count();
            }
        }
    }
    assert!(count > 1000, "{count} comments");
}

#[test]
fn a_broken_comment_is_found() {
    assert_eq!(fault("a (* b *) c (* d\n e *)"), None);
    for broken in ["a (* b", "a *) b", "(* a (* b *) c", "(* a (* b *) c *)", "a // b", "(* a *) b *)"] {
        assert!(fault(broken).is_some(), "{broken}");
    }
}

/// What gives away a machine, a person or a day: a path, an address, a clock, a date. Two are fixed: the date that
/// PLCopen asks for, and names of XML's vocabularies.
fn traces(text: &str) -> Vec<&str> {
    const FIXED: [&str; 5] = [
        "http://www.3s-software.com/plcopenxml/",
        "creationDateTime=\"2000-01-01T00:00:00\"",
        "http://www.plcopen.org/xml/tc6_0200",
        "http://www.w3.org/1999/xhtml",
        "http://schemas.microsoft.com/developer/msbuild/2003",
    ];
    let is_clock = |word: &str| {
        let digits: Vec<&str> = word.trim_matches(|c: char| !c.is_ascii_digit()).split(':').collect();
        digits.len() > 1 && digits.iter().all(|part| part.len() == 2 && part.bytes().all(|c| c.is_ascii_digit()))
    };
    let is_date = |word: &str| {
        let parts: Vec<&str> = word.trim_matches(|c: char| !c.is_ascii_digit()).split(['-', '.']).collect();
        parts.len() == 3 && parts.iter().all(|part| part.parse::<u32>().is_ok()) && parts.iter().any(|p| p.len() == 4)
    };
    let is_path = |word: &str| {
        let word = word.trim_start_matches(['"', '\'', '(', '`', '<', '[']);
        let is_root = word.starts_with('/') && word[1..].starts_with(|c: char| c.is_ascii_alphabetic());
        let is_drive = word.get(1..3) == Some(":\\") || word.starts_with("\\\\") || word.starts_with("~/");
        is_root || is_drive || word.contains("://") || word.contains("../")
    };
    let is_address = |word: &str| word.contains('@');
    let is_trace = |word: &&str| {
        !FIXED.iter().any(|fixed| word.contains(fixed))
            && (is_clock(word) || is_date(word) || is_path(word) || is_address(word))
    };
    text.split_ascii_whitespace().filter(is_trace).collect()
}

#[test]
fn no_file_gives_away_where_or_when_it_was_made() {
    let here = env!("CARGO_MANIFEST_DIR").trim_end_matches("/generator");
    let host = std::fs::read_to_string("/etc/hostname").unwrap_or_default();
    let user = std::env::var("USER").unwrap_or_default();
    // A short or common name would be found in ordinary words.
    let own: Vec<&str> = [here, host.trim(), user.trim()].into_iter().filter(|name| name.len() > 5).collect();
    for case in CASES.iter() {
        // The end tags of XML are no paths.
        for (name, text) in &case.files {
            let text = text.replace("</", "<");
            let text = match name.rsplit_once('.').unwrap().1 {
                "c" | "h" => text.replace("/*", ""),
                "rs" => text.replace("//", "").replace("#[path = \"../", "\""),
                _ => text,
            };
            assert_eq!(traces(&text), [""; 0], "{}: {name}", case.name);
            assert_eq!(own.iter().find(|own| text.contains(**own)), None, "{}: {name}", case.name);
        }
    }
}

#[test]
fn a_trace_is_found() {
    for text in ["/home/x/a.toml", "at 12:30", "2026-11-21", "21.11.2026", "C:\\x", "me@host", "\"/tmp\"", "../a"] {
        assert_eq!(traces(text).len(), 1, "{text}");
    }
    assert_eq!(traces("1 / x, a/b, stage 1: 2, -3 dB at 50.4, 16#7FF0, P-AXIS-00753, */"), [""; 0]);
}
