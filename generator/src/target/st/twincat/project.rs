//! The files that all axes of a set share in TwinCAT: the function, the enumerations, the test program, the project's
//! entries, the guide.

use super::{DUTS, FOLDER, POUS, TESTS, block_name, guid, in_range, rendered, suite};
use crate::target::st::enumeration::{Enumeration, enumerations};
use crate::target::st::{block_names, listing::set_name, real_types, self_test};
use crate::target::{self, File, Unit};
use askama::Template;

/// An enumeration, with the reference's numbers.
#[derive(Template)]
#[template(path = "twincat/enumeration.TcDUT")]
struct TcEnum<'a> {
    id: String,
    name: &'a str,
    of: &'a Enumeration,
}

/// The program that runs all suites.
#[derive(Template)]
#[template(path = "twincat/tests.TcPOU")]
pub(super) struct TcProgram {
    pub(super) id: String,
    pub(super) suites: Vec<String>,
}

/// The entries of a project file.
#[derive(Template)]
#[template(path = "twincat/plcproj_entries.xml")]
struct TcProject {
    /// objects that the machine runs
    objects: Vec<String>,
    /// objects that only the tests need
    tests: Vec<String>,
}

#[derive(Template)]
#[template(path = "twincat/IMPORT.md")]
struct TcGuide;

/// The shared files.
pub(crate) fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let names = |unit: &Unit<'_>| unit.blocks.iter().map(|block| block_name(unit.axis, block)).collect::<Vec<_>>();
    let mut blocks: Vec<String> = units.iter().flat_map(names).collect();
    // Sorted by name, so that the order of the axes in the set does not matter.
    blocks.sort();
    let enumeration = |of: &Enumeration| {
        let name = &format!("E_axgen_{}", of.signal);
        rendered(DUTS, &format!("{name}.TcDUT"), &TcEnum { id: guid("DUT", name), name, of })
    };
    let mut files: Vec<File> = enumerations(block_names(units)).iter().map(enumeration).collect();
    for real in real_types(units) {
        let function = in_range(real);
        files.push(rendered(POUS, &format!("{}.TcPOU", function.name), &function));
    }
    let suites = blocks.iter().map(|block| suite::suite_name(block)).collect();
    let program = TcProgram { id: guid("POU", "PRG_axgen_tests"), suites };
    files.push(rendered(TESTS, "PRG_axgen_tests.TcPOU", &program));
    let params = units.iter().filter(|unit| unit.takes_sets).map(|unit| set_name(unit.axis));
    let project = project(&files, &blocks, params);
    files.extend([project, target::rendered(&format!("{FOLDER}/IMPORT.md"), "", &TcGuide)]);
    files
}

/// The entries of the project file: the shared files, and those of every block.
fn project(shared: &[File], blocks: &[String], params: impl Iterator<Item = String>) -> File {
    let of_block = |block: &String| {
        let (suite, test) = (suite::suite_name(block), self_test::name(block));
        [format!("{POUS}\\{block}.TcPOU"), format!("{TESTS}\\{suite}.TcPOU"), format!("{TESTS}\\{test}.TcPOU")]
    };
    let shared = shared.iter().map(|file| file.name[FOLDER.len() + 1..].replace('/', "\\"));
    let params = params.map(|name| format!("{DUTS}\\{name}.TcDUT"));
    let mut entries: Vec<String> = shared.chain(params).chain(blocks.iter().flat_map(of_block)).collect();
    entries.sort();
    let (tests, objects) = entries.into_iter().partition(|entry| entry.starts_with(TESTS));
    target::rendered(&format!("{FOLDER}/axgen.plcproj-fragment"), "", &TcProject { objects, tests })
}
