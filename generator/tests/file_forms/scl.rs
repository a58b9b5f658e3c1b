//! SCL: the strict engine takes every block and every self-test of every source, and no source has others.

use super::CASES;
use st::{Block, Dialect};

#[test]
fn the_engine_takes_every_block_of_every_source() {
    let mut count = 0;
    for case in CASES.iter() {
        for of in &case.set.axes {
            let axis = &of.axis;
            // `set_design` uses the type of the sets of `ipc`.
            let mut before = Vec::new();
            for kind in generator::blocks::of_axis(axis) {
                let stem = format!("axis_{}_{}", axis.name.to_ascii_lowercase(), kind.name());
                let real = kind.program(of, None).unwrap().real;
                let read = |name: &str, others: &[Block]| {
                    let text = &case.files[&format!("{name}.scl")];
                    let header = format!("FUNCTION_BLOCK \"FB_{name}\"");
                    let found = text.lines().filter(|line| line.starts_with("FUNCTION_BLOCK"));
                    assert!(found.eq([header]), "{}: {name}", case.name);
                    let read = Block::read_with(Dialect::Scl, text, &format!("FB_{name}"), real, others);
                    read.unwrap_or_else(|mistakes| panic!("{}: {name}: {mistakes:?}", case.name))
                };
                before.insert(0, read(&stem, &before));
                read(&format!("{stem}_self_test"), &before);
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count} blocks");
}

/// The modes stand there once, with the numbers of the reference.
#[test]
fn the_modes_are_a_data_block() {
    let text = &CASES[0].files["axgen_mode.scl"];
    let members: Vec<&str> = text
        .lines()
        .filter(|line| line.contains(" : DInt := "))
        .filter_map(|line| line.trim().split(" (*").next())
        .collect();
    assert_eq!(members, ["MODE_OFF : DInt := 0;", "MODE_ON : DInt := 1;", "MODE_DRYRUN : DInt := 2;"]);
    assert!(text.contains("\nDATA_BLOCK \"axgen_mode\"\n") && text.ends_with("\nBEGIN\nEND_DATA_BLOCK\n"));
}
