//! Prints what cannot be shown of each block of the golden cases, or of those whose folders are named.
#![expect(clippy::print_stdout, reason = "it prints what it has found")]

use generator::blocks::of_axis;
use golden::case;
use std::env::args;
use std::path::Path;

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases");
    let named: Vec<String> = args().skip(1).collect();
    for folder in case::folders(&root).expect("the cases") {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if !named.is_empty() && !named.contains(&name) {
            continue;
        }
        let designed = case::axis(&folder).expect("the axis of a case");
        for kind in of_axis(&designed.axis) {
            let shown = kind.shown(&designed).expect("a program");
            println!("{name} {}: {}", kind.name(), shown.findings.len());
            shown.findings.iter().for_each(|finding| println!("    {finding}"));
        }
    }
}
