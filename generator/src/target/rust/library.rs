//! The files that the modules of all axes share: a crate with a feature for each block, and the trait of all blocks.

use crate::blocks::{IPC, SET_DESIGN, WHOLE};
use crate::target::{File, Unit, block_name, rendered};
use askama::Template;

/// The folder of the crate.
const FOLDER: &str = "rust/";

#[derive(Template)]
#[template(path = "rust/Cargo.toml")]
struct Manifest<'m> {
    modules: &'m [Module],
}

#[derive(Template)]
#[template(path = "rust/lib.rs")]
struct Library<'m> {
    modules: &'m [Module],
}

/// The module of a block.
struct Module {
    name: String,
    /// the module that it uses
    uses: Option<String>,
}

pub(in crate::target) fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let of_axis = |unit: &Unit<'_>| -> Vec<Module> {
        // The module of `ipc` declares the type of the sets.
        let shares_sets = |block: &str| block == SET_DESIGN || unit.takes_sets && WHOLE.contains(&block);
        let module = |block: &&str| Module {
            name: block_name(unit.axis, block),
            uses: shares_sets(block).then(|| block_name(unit.axis, IPC)),
        };
        unit.blocks.iter().map(module).collect()
    };
    let mut modules: Vec<Module> = units.iter().flat_map(of_axis).collect();
    modules.sort_by(|one, other| one.name.cmp(&other.name));
    let modules = modules.as_slice();
    vec![
        rendered(&format!("{FOLDER}Cargo.toml"), "", &Manifest { modules }),
        rendered(&format!("{FOLDER}lib.rs"), "", &Library { modules }),
    ]
}
