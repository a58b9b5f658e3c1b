//! The emitted files as a user's build sees them: no warning under strict options, fit for C++, no undefined symbol.

use crate::{cases, in_turn, tools};
use axgen_tests::cases::{title, without_stages};
use axgen_tests::environment::has;
use generator::generate::identity;
use generator::target::{File, TARGETS};
use golden::case::Case;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

const STRICT: [&str; 8] =
    ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wfloat-equal", "-Werror"];
const CPP: [&str; 6] = ["-std=c++98", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"];
const LEVELS: [&[&str]; 8] = [
    &["-O0"],
    &["-O1"],
    &["-O2"],
    &["-O3"],
    &["-Os"],
    &["-O0", "-ffreestanding"],
    &["-O2", "-ffreestanding"],
    &["-O3", "-march=native", "-ffp-contract=off"],
];

#[test]
fn strict_compilers_have_nothing_to_say() {
    for tool in tools() {
        blocks().par_iter().enumerate().for_each(|(number, case)| {
            let (folder, stem) = written(case);
            for level in in_turn(&["-O0", "-O2"], number, 1) {
                let sources = [&format!("{stem}.c")[..], &format!("{stem}_self_test.c")];
                compile(tool.command, folder.path(), &[&STRICT[..], &[level, "-c"], &sources].concat());
            }
        });
    }
}

/// The files of all blocks of an axis, one after another in the same folder, and the headers next to each other.
#[test]
fn all_blocks_of_an_axis_stand_beside_each_other() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/feedforward.toml");
    let (set, report) = generator::pipeline::read(&path, &generator::config::ListOptions::default());
    let axes = set.unwrap_or_else(|| panic!("{report}")).axes;
    assert!(axes.iter().any(|of| generator::blocks::names(&of.axis).len() == 4));
    let (tools, axes) = (tools(), [axes, without_stages().to_vec()].concat());
    for (tool, axis) in tools.iter().flat_map(|tool| axes.iter().map(move |axis| (tool, axis))) {
        let folder = tempfile::tempdir().unwrap();
        let files = generator::generate::axis_files(axis, &TARGETS[..1]).unwrap();
        let mut all = String::new();
        for File { name, text } in &files {
            std::fs::write(folder.path().join(name), text).unwrap();
            if name.ends_with(".h") {
                all.push_str(&format!("#include \"{name}\"\n"));
            }
        }
        std::fs::write(folder.path().join("all.c"), all).unwrap();
        let sources = files.iter().map(|file| file.name.as_str()).filter(|name| name.ends_with(".c")).chain(["all.c"]);
        let levels =
            |(number, source)| in_turn(&["-O0", "-O2"], number, 1).into_iter().map(move |level| (source, level));
        for (source, level) in sources.enumerate().flat_map(levels) {
            compile(
                tool.command,
                folder.path(),
                &[&STRICT[..], &["-Wshadow", level, "-c", source, "-o", "block.o"]].concat(),
            );
        }
    }
}

/// Twice in one file, and called from there.
#[test]
fn the_header_is_fit_for_cpp() {
    for tool in tools().into_iter().filter(|tool| has(tool.cpp, tool.version_contains, tool.package)) {
        blocks().par_iter().for_each(|case| {
            let (folder, stem) = written(case);
            let prefix = &stem;
            let text = format!(
                "#include \"{stem}.h\"\n#include \"{stem}.h\"\n\
                 uint32_t run({prefix}_state &state, {prefix}_inputs &inputs, {prefix}_outputs &outputs)\n{{\n    \
                 {prefix}_init(&state);\n    {prefix}_inputs_init(&inputs);\n    \
                 {prefix}_step(&state, &inputs, &outputs);\n    return {prefix}_self_test();\n}}\n"
            );
            std::fs::write(folder.path().join("caller.cpp"), text).unwrap();
            compile(tool.cpp, folder.path(), &[&CPP[..], &["caller.cpp"]].concat());
        });
    }
}

/// No library, no memset or memcpy that the compiler makes of a loop or a copy, and nothing writable but the
/// caller's. A self-test needs its block.
#[test]
fn objects_need_no_symbol_and_hold_no_writable_data() {
    if !has("nm", "nm", "binutils") {
        return;
    }
    for tool in tools() {
        blocks().par_iter().enumerate().for_each(|(number, case)| {
            let (folder, stem) = written(case);
            for level in in_turn(&LEVELS, number, 1) {
                // Some distributions switch the stack protector on, which is a symbol of theirs.
                let sources = [format!("{stem}.c"), format!("{stem}_self_test.c")];
                let options = ["-std=c99", "-fno-stack-protector", "-c", &sources[0], &sources[1]];
                compile(tool.command, folder.path(), &[&options, level].concat());
                for (what, function, needs) in
                    [("", "_step", &[][..]), ("_self_test", "_self_test", &["_init", "_inputs_init", "_step"])]
                {
                    let object = format!("{stem}{what}.o");
                    let needs: String = needs.iter().map(|name| format!("{stem}{name}\n")).collect();
                    let what = format!("{}: {object} {} {level:?}", title(case), tool.command);
                    assert_eq!(symbols(folder.path(), &["-u", "-j", &object]), needs, "{what}: undefined");
                    let all = symbols(folder.path(), &["--format=posix", &object]);
                    let kinds = all.lines().filter_map(|line| line.split_whitespace().nth(1));
                    let writable: Vec<&str> = kinds.filter(|kind| "BbCDdGgSs".contains(kind)).collect();
                    assert!(all.contains(&format!("{stem}{function} T")) && writable.is_empty(), "{what}: {all}");
                }
            }
        });
    }
}

fn symbols(folder: &Path, options: &[&str]) -> String {
    let output = Command::new("nm").args(options).current_dir(folder).output();
    let output = output.unwrap_or_else(|error| panic!("nm: {error}"));
    assert!(output.status.success(), "{output:?}");
    // Position-independent code names the linker's table.
    String::from_utf8_lossy(&output.stdout).replace("_GLOBAL_OFFSET_TABLE_\n", "")
}

/// The cases of this run, those of one block that differ in their stimulus only once: their files are the same.
fn blocks() -> Vec<Case> {
    let mut seen = BTreeSet::new();
    let mut cases = cases();
    cases.retain(|case| seen.insert(files(case).swap_remove(1).text));
    cases
}

fn files(case: &Case) -> Vec<File> {
    TARGETS[0].files(&identity(&case.axis.axis, &case.block), &case.block).expect("the target prints the block")
}

/// The emitted files in a folder, and what their names begin with.
fn written(case: &Case) -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let files = files(case);
    let headers = golden::engine::headers(&case.axis, &case.block).unwrap_or_else(|failure| panic!("{failure}"));
    for File { name, text } in files.iter().chain(&headers) {
        std::fs::write(folder.path().join(name), text).expect("room in it");
    }
    (folder, files[0].name.trim_end_matches(".h").to_owned())
}

/// Compiles with no word from the compiler.
pub fn compile(command: &str, folder: &Path, arguments: &[&str]) {
    let output = Command::new(command).args(arguments).current_dir(folder).output();
    let output = output.unwrap_or_else(|error| panic!("{command}: {error}"));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{command} {}:\n{said}", arguments.join(" "));
}
