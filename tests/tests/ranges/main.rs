//! What the range analysis shows: of every golden case all that it should, of ten planted defects none; and what runs from any state
//! stays within what was shown.

#![expect(clippy::cast_possible_truncation, clippy::cast_lossless, reason = "random bits")]

mod planted;
mod sound;

use generator::blocks::{Designed, Kind, of_axis};
use golden::case;
use std::path::Path;

/// Of every golden case its axis, with its blocks; without those of spindles, whose state is not yet shown.
fn subjects() -> Vec<(String, Designed, &'static dyn Kind)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases");
    let mut subjects = Vec::new();
    for folder in case::folders(&root).expect("the cases") {
        let designed = case::axis(&folder).expect("the axis of a case");
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        for kind in of_axis(&designed.axis).filter(|kind| !kind.name().starts_with("spindle")) {
            subjects.push((format!("{name}, {}", kind.name()), designed.clone(), kind));
        }
    }
    subjects
}

#[test]
fn every_golden_case_is_shown() {
    let subjects = subjects();
    assert!(subjects.len() > 50, "{} blocks", subjects.len());
    for (name, designed, kind) in subjects {
        let shown = kind.shown(&designed).expect("a program");
        assert!(shown.findings.is_empty(), "{name}: {:#?}", shown.findings);
    }
}
