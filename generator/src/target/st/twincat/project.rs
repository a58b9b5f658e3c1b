//! What all axes of a set share in TwinCAT: the function, the types, the test program, the project's entries, the guide.

use super::{DUTS, FOLDER, POUS, TESTS, block_name, guid, in_range, rendered, suite, word_name};
use crate::target::st::real_types;
use crate::target::{self, File, Unit};
use askama::Template;
use compiler::print::st::CODESYS;
use compiler::program::Type;
use portable::RealKind;

/// The enumeration of the modes, with the reference's numbers.
#[derive(Template)]
#[template(path = "twincat/mode.TcDUT")]
struct TcEnum {
    id: String,
}

/// The union of a real and its bits.
#[derive(Template)]
#[template(path = "twincat/bits.TcDUT")]
struct TcUnion<'a> {
    id: String,
    real: &'a str,
    /// the bit string of the same size
    word: &'a str,
}

/// The program that runs all suites.
#[derive(Template)]
#[template(path = "twincat/tests.TcPOU")]
pub(super) struct TcProgram {
    pub(super) id: String,
    pub(super) suites: Vec<String>,
}

/// What a project file has to name.
#[derive(Template)]
#[template(path = "twincat/axgen.plcproj")]
struct TcProject {
    /// what the machine runs
    objects: Vec<String>,
    /// what only the tests need
    tests: Vec<String>,
}

/// The guide, with a call of the first block of each kind that is called for itself; empty: there is none.
#[derive(Template)]
#[template(path = "twincat/IMPORT.md")]
pub(super) struct TcGuide<'a> {
    pub(super) damping: &'a str,
    pub(super) axis: &'a str,
}

/// The shared files.
pub(crate) fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let names = |unit: &Unit<'_>| unit.blocks.iter().map(|block| block_name(unit.axis, block)).collect::<Vec<_>>();
    let mut blocks: Vec<String> = units.iter().flat_map(names).collect();
    // By name, so that an axis can move in the set.
    blocks.sort();
    let modes = "E_axgen_mode";
    let mut files = vec![rendered(DUTS, &format!("{modes}.TcDUT"), &TcEnum { id: guid("DUT", modes) })];
    for real in real_types(units) {
        let function = in_range(real);
        files.push(rendered(POUS, &format!("{}.TcPOU", function.name), &function));
        files.push(bits(real));
    }
    let suites = blocks.iter().map(|block| suite::suite_name(block)).collect();
    let program = TcProgram { id: guid("POU", "PRG_axgen_tests"), suites };
    files.push(rendered(TESTS, "PRG_axgen_tests.TcPOU", &program));
    let project = project(&files, &blocks);
    let first = |block: &str| {
        let having = units.iter().filter(|unit| unit.blocks.contains(&block));
        having.map(|unit| block_name(unit.axis, block)).min().unwrap_or_default()
    };
    let guide = TcGuide { damping: &first("ipc"), axis: &first("axis") };
    files.extend([project, target::rendered(&format!("{FOLDER}/IMPORT.md"), "", &guide)]);
    files
}

fn bits(real: RealKind) -> File {
    let (real, word) = (CODESYS.ty(Type::Real, real), word_name(real));
    let name = format!("U_axgen_{real}");
    rendered(TESTS, &format!("{name}.TcDUT"), &TcUnion { id: guid("DUT", &name), real, word })
}

/// What the project file has to name: the shared files, and those of every block.
fn project(shared: &[File], blocks: &[String]) -> File {
    let of_block = |block: &String| {
        let (suite, vector) = (suite::suite_name(block), suite::vector_name(block));
        [format!("{POUS}\\{block}.TcPOU"), format!("{TESTS}\\{suite}.TcPOU"), format!("{TESTS}\\{vector}.TcGVL")]
    };
    let shared = shared.iter().map(|file| file.name[FOLDER.len() + 1..].replace('/', "\\"));
    let mut entries: Vec<String> = shared.chain(blocks.iter().flat_map(of_block)).collect();
    entries.sort();
    let (tests, objects) = entries.into_iter().partition(|entry| entry.starts_with(TESTS));
    target::rendered(&format!("{FOLDER}/axgen.plcproj"), "", &TcProject { objects, tests })
}
