//! The named values in the headers of C: of every signal that the comments describe by its values, all of them and no other.

use super::CASES;
use std::collections::{BTreeMap, BTreeSet};

/// The enumerations of a header by their first line: name without the block's prefix, number.
fn enumerations(text: &str, prefix: &str) -> BTreeMap<String, BTreeMap<String, i64>> {
    let mut found = BTreeMap::new();
    let lines: Vec<&str> = text.lines().collect();
    for at in (1..lines.len()).filter(|at| lines[*at] == "enum {") {
        let members = lines[at + 1..].iter().take_while(|line| **line != "};").filter_map(|line| {
            let (name, value) = line.trim_start().strip_prefix(prefix)?.split_once(" = ")?;
            let number = value.split([',', ' ']).next().unwrap_or_default();
            Some((name.to_owned(), number.parse().unwrap()))
        });
        found.insert(lines[at - 1].to_owned(), members.collect());
    }
    found
}

#[test]
fn every_named_value_of_a_signal_is_in_the_header() {
    let mut seen = BTreeSet::new();
    for case in CASES.iter() {
        for (file, text) in case.with(&[".h"]) {
            let prefix = format!("{}_", file.trim_end_matches(".h").to_ascii_uppercase());
            let enumerations = enumerations(text, &prefix);
            let values = |signal: &str| {
                let of = enumerations.iter().find(|(note, _)| note.contains(&format!(" {signal}")));
                of.map(|(_, values)| values).unwrap_or_else(|| panic!("{}: {file}: {signal}", case.name))
            };
            // The ids stand in the comment of the output as well: 0 none, 1 cycle_time, ...
            let flat = text.replace("\n     * ", " ");
            let (before, after) = flat.split_once("uint32_t error_id;").unwrap();
            let comment = if after.starts_with(" /*") { after } else { before.rsplit_once("    /*").unwrap().1 };
            let listed = comment[comment.find("0 none").unwrap()..].split("*/").next().unwrap();
            let ids: BTreeMap<String, i64> = listed
                .split(", ")
                .map(|id| id.trim().split_once(' ').unwrap())
                .map(|(id, name)| (format!("ERROR_{}", name.to_ascii_uppercase()), id.parse().unwrap()))
                .collect();
            assert_eq!(values("error_id"), &ids, "{}: {file}", case.name);
            let expected: [(&str, &str, &[&str]); 3] = [
                ("    int32_t mode;", "input mode", &["MODE_OFF", "MODE_ON", "MODE_DRYRUN"]),
                ("    int32_t job;", "output job", &["JOB_STOP", "JOB_TURN", "JOB_ORIENT", "JOB_RELEASE", "JOB_HOME"]),
                (
                    "    int32_t spindle_state;",
                    "output spindle_state",
                    &["POSITION", "TO_VELOCITY", "VELOCITY", "BRAKE", "TO_POSITION"],
                ),
            ];
            for (_, signal, names) in expected.into_iter().filter(|(member, ..)| text.contains(member)) {
                let numbers: Vec<i64> = names
                    .iter()
                    .map(|name| {
                        values(signal).get(*name).or_else(|| values(signal).get(&format!("SPINDLE_STATE_{name}")))
                    })
                    .map(|number| *number.unwrap())
                    .collect();
                let counted: Vec<i64> = (0..).take(names.len()).collect();
                assert!(numbers == counted && values(signal).len() == names.len(), "{}: {file}: {signal}", case.name);
                seen.insert(signal);
            }
        }
    }
    assert_eq!(seen.len(), 3, "{seen:?}");
}
