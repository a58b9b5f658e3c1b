//! What each file form demands of its files: XML, TwinCAT objects, TcUnit suites, PLCopen, SCL, checksums, plain text. What the
//! files compute is compared by the engines.

mod cdata;
mod checksum;
mod encoding;
mod plcopen;
mod project;
mod scl;
mod structure;
mod suite;
mod text;
mod twincat;
mod values;
mod xml;

use crate::{files, from_disk, set_of};
use generator::pipeline::Set;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

struct Case {
    name: String,
    set: Set,
    files: BTreeMap<String, String>,
}

impl Case {
    /// The files with one of these endings, with their names.
    fn with(&self, endings: &[&str]) -> Vec<(&String, &String)> {
        self.files.iter().filter(|(name, _)| endings.iter().any(|ending| name.ends_with(ending))).collect()
    }
}

/// The endings of TwinCAT's objects.
const OBJECTS: [&str; 2] = [".TcPOU", ".TcDUT"];

/// The examples, every golden case, and a set with all stages full in both real types.
static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let mut cases = vec![
        case("examples/machine.toml", from_disk(&root.join("examples/machine.toml"))),
        case("examples/rack-and-pinion.lis", from_disk(&root.join("examples/rack-and-pinion.lis"))),
        case("full.toml", full()),
    ];
    let folders = std::fs::read_dir(root.join("golden/cases")).unwrap().map(|entry| entry.unwrap().path());
    let mut sets: Vec<_> = folders.map(|folder| folder.join("set.toml")).filter(|set| set.exists()).collect();
    sets.sort();
    assert!(sets.len() >= 16, "{} golden sets", sets.len());
    cases.extend(
        sets.iter().map(|set| case(set.parent().unwrap().file_name().unwrap().to_str().unwrap(), from_disk(set))),
    );
    cases
});

fn case(name: &str, set: Set) -> Case {
    let files = files(&set);
    Case { name: name.to_owned(), set, files }
}

/// Three full stages with an all-pass each, an axis in each real type; a name that a language could take for a word.
fn full() -> Set {
    const STAGES: &str = include_str!("stages.toml");
    let axis = |name: &str, real: &str| {
        format!(
            "[axis.{name}]\naccept_unstable = true\nreal = \"{real}\"\ngetriebe = [{{ dynamik.vb_max = 500000 }}]\n\
             [axis.{name}.lr_param.improved_position_control]\nenable = \"ON\"\nv_add_max_fact = 1000{STAGES}"
        )
    };
    let text = format!("cycle_time = \"1ms\"\n{}{}", axis("WIDE_1", "f64"), axis("end_if", "f32"));
    set_of(&text)
}
