//! The table of the error ids: as long as the reference's, and what the page and the guides say.

use crate::{files, set_of};
use generator::error_ids::{all, page};
use std::collections::BTreeSet;
use std::path::Path;

const SET: &str = "cycle_time = '1ms'\n[axis.X]\ngetriebe = [{ dynamik.vb_max = 530000 }]\n";

#[test]
fn every_id_of_the_reference_has_a_row() {
    let reference = include_str!("../../../reference/src/signal.rs");
    let bodies = reference.split("pub fn error_").skip(1).map(|rest| rest.split_once('{').unwrap().1);
    let ids: Vec<u32> =
        bodies.map(|body| body.split_once("u32").unwrap().0.trim().replace('_', "").parse().unwrap()).collect();
    let expected: BTreeSet<u32> = ids.into_iter().filter(|id| *id != 0).collect();
    let rows: Vec<u32> = all().map(|row| row.id).collect();
    assert_eq!(rows.iter().copied().collect::<BTreeSet<u32>>(), expected);
    assert_eq!(rows.len(), expected.len(), "no id has two rows");
    for row in all() {
        assert!(
            [row.why, row.does, row.remedy]
                .iter()
                .all(|text| !text.is_empty() && text.is_ascii() && !text.contains('|'))
        );
        assert!(row.does.ends_with('.') && row.remedy.ends_with(['.', ')']), "{}", row.id);
    }
}

#[test]
fn the_page_is_the_table() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/error-ids.md");
    transcript::equals(path, &page());
}

#[test]
fn the_guides_have_each_id() {
    let guides: Vec<_> = files(&set_of(SET)).into_iter().filter(|(name, _)| name.contains("IMPORT")).collect();
    assert_eq!(guides.len(), 3);
    for (name, text) in guides {
        for row in all() {
            assert!(text.contains(&format!("| {} | {} | {} |", row.id, row.does, row.remedy)), "{name}: {}", row.id);
        }
    }
}
