//! What all axes of a set share in TwinCAT: the function, the types, the test program, the project's entries, the guide.

use super::{DUTS, FOLDER, POUS, TESTS, block_name, guid, in_range, rendered, suite, word_name};
use crate::digest::NO_CHECKSUM;
use crate::render::{Compile, Item, TcEnum, TcGuide, TcProgram, TcProject, TcUnion};
use crate::target::st::real_types;
use crate::target::{self, File, Unit, VERSION};
use crate::vector;
use compiler::print::st::type_name;
use compiler::program::Type;
use portable::RealKind;
use reference::ipc::{mode_dryrun, mode_off, mode_on};

/// The shared files.
pub(crate) fn shared(units: &[Unit<'_>]) -> Vec<File> {
    let mut blocks: Vec<String> =
        units.iter().flat_map(|unit| unit.blocks.iter().map(|block| block_name(unit.axis, block))).collect();
    // By name, so that an axis can move in the set.
    blocks.sort();
    let suites: Vec<String> = blocks.iter().map(|block| suite::suite_name(block)).collect();
    let mut files = vec![modes()];
    for real in real_types(units) {
        let function = in_range(real);
        files.push(rendered(POUS, format!("{}.TcPOU", function.name), &function));
        files.push(bits(real));
    }
    let program = TcProgram {
        version: VERSION,
        checksum: NO_CHECKSUM,
        id: guid::derive("POU", "PRG_axgen_tests"),
        suites: &suites,
    };
    files.push(rendered(TESTS, "PRG_axgen_tests.TcPOU".to_owned(), &program));
    let project = project(&files, &blocks);
    files.push(project);
    files.push(guide(units));
    files
}

/// The enumeration of the modes, with the reference's numbers.
fn modes() -> File {
    let item = |name, value| Item { name, value };
    let items = [item("MODE_OFF", mode_off()), item("MODE_ON", mode_on()), item("MODE_DRYRUN", mode_dryrun())];
    let name = "E_axgen_mode";
    let file = TcEnum { version: VERSION, checksum: NO_CHECKSUM, id: guid::derive("DUT", name), items: &items };
    rendered(DUTS, format!("{name}.TcDUT"), &file)
}

/// The union of a real and its bits.
fn bits(real: RealKind) -> File {
    let (real, word) = (type_name(Type::Real, real), word_name(real));
    let name = format!("U_axgen_{real}");
    let file = TcUnion { version: VERSION, checksum: NO_CHECKSUM, id: guid::derive("DUT", &name), real, word };
    rendered(TESTS, format!("{name}.TcDUT"), &file)
}

/// What the project file has to name: the shared files, and those of every block.
fn project(shared: &[File], blocks: &[String]) -> File {
    let mut entries: Vec<Compile> = shared.iter().filter_map(|file| entry(&file.name)).collect();
    for block in blocks {
        entries.push(Compile { folder: POUS, file: format!("{block}.TcPOU") });
        entries.push(Compile { folder: TESTS, file: format!("{}.TcPOU", suite::suite_name(block)) });
        entries.push(Compile { folder: TESTS, file: format!("{}.TcGVL", suite::vector_name(block)) });
    }
    entries.sort_by(|a, b| (a.folder, &a.file).cmp(&(b.folder, &b.file)));
    let (tests, objects): (Vec<_>, Vec<_>) = entries.into_iter().partition(|entry| entry.folder == TESTS);
    let file = TcProject { version: VERSION, checksum: NO_CHECKSUM, objects: &objects, tests: &tests };
    target::rendered(format!("{FOLDER}/axgen.plcproj"), "", &file)
}

/// The entry of a file that has been made.
fn entry(name: &str) -> Option<Compile> {
    let (folder, file) = name.strip_prefix(FOLDER)?.strip_prefix('/')?.split_once('/')?;
    let folder = [POUS, DUTS, TESTS].into_iter().find(|known| *known == folder)?;
    Some(Compile { folder, file: file.to_owned() })
}

/// The guide, with a call of the first block of each kind that is called for itself.
fn guide(units: &[Unit<'_>]) -> File {
    let first = |block: &str| {
        let having = units.iter().filter(|unit| unit.blocks.contains(&block));
        having.map(|unit| block_name(unit.axis, block)).min().unwrap_or_default()
    };
    let (damping, axis) = (first("ipc"), first("axis"));
    let guide =
        TcGuide { version: VERSION, checksum: NO_CHECKSUM, damping: &damping, axis: &axis, samples: vector::SAMPLES };
    target::rendered(format!("{FOLDER}/IMPORT.md"), "", &guide)
}
