//! Prints what cannot be shown of each block of the golden cases.

use generator::blocks::blocks;
use golden::case;
use std::path::Path;

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases");
    for folder in case::folders(&root).expect("the cases") {
        let Ok(case) = case::read(&folder) else {
            println!("{folder:?}: unreadable");
            continue;
        };
        for block in blocks(&case.axis).expect("blocks") {
            println!(
                "{} {}: {}",
                folder.file_name().unwrap_or_default().to_string_lossy(),
                block.program.block,
                block.ranges.findings.len()
            );
            for finding in &block.ranges.findings {
                println!("    {finding}");
            }
        }
    }
}
