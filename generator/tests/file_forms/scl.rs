//! SCL: the strict engine takes every block of every source, and no source has others.

use crate::CASES;
use st::{Block, Dialect};

#[test]
fn the_engine_takes_every_block_of_every_source() {
    let mut count = 0;
    for case in CASES.iter() {
        for axis in case.set.axes.iter().map(|of| &of.axis) {
            let stem = format!("axis_{}", axis.name.to_ascii_lowercase());
            let text = &case.files[&format!("{stem}.scl")];
            let names: Vec<String> =
                generator::blocks::names(axis).iter().map(|block| format!("FB_{stem}_{block}")).collect();
            let headers = names.iter().map(|name| format!("FUNCTION_BLOCK \"{name}\""));
            let found = text.lines().filter(|line| line.starts_with("FUNCTION_BLOCK"));
            assert!(found.eq(headers), "{}: {stem}", case.name);
            for name in &names {
                let read = Block::read(Dialect::Scl, text, name, axis.real);
                assert!(read.is_ok(), "{}: {stem}: {:?}", case.name, read.err());
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count} blocks");
}
