//! The emitted Rust as a user's crate sees it: no warning, no panic, no unsafe; tools of the toolchain leave it alone, the example
//! of its documentation runs, and its self-test finds what a build could do wrong. What it computes is compared by the engines.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::print_stdout, reason = "`--nocapture` shows how many faults were planted and found")]

use axgen_tests::cases::{all, in_both_real_types, title, without_stages};
use axgen_tests::environment::{by_depth, has, said};
use generator::generate::{axis_files, identity};
use generator::target::{self, File};
use golden::case::{self, Case, VECTOR_SAMPLES};
use golden::engine::{self, Failure, rust};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// The module of a case, and those that it uses.
fn module(case: &Case) -> Vec<File> {
    let target = target::named("rust").unwrap();
    let used = engine::of_set(target, &case.axis, &case.block).unwrap();
    let mut files = target.files(&identity(&case.axis.axis, &case.block), &case.block).unwrap();
    files.extend(used);
    files
}

/// A crate of modules, without the standard library and without unsafe code. Each lies in a folder of its own: names repeat.
fn library(modules: &[Vec<File>]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let (mut root, mut callers) = ("#![no_std]\n#![forbid(unsafe_code)]\n".to_owned(), String::new());
    for (number, files) in modules.iter().enumerate() {
        let below = format!("m{number:03}"); // rustfmt sorts them
        std::fs::create_dir(folder.path().join(&below)).unwrap();
        for file in files {
            std::fs::write(folder.path().join(&below).join(&file.name), &file.text).unwrap();
        }
        root += &match files.as_slice() {
            [file] => format!("#[path = \"{below}/{}\"]\npub mod {below};\n", file.name),
            files => {
                let mut names: Vec<&str> = files.iter().map(|file| file.name.trim_end_matches(".rs")).collect();
                let block = names[0];
                names.sort_unstable();
                let all: String = names.iter().map(|name| format!("    pub mod {name};\n")).collect();
                format!("pub mod {below} {{\n{all}    pub use self::{block}::*;\n}}\n")
            }
        };
        // A small function is in no object until one that must not be inlined calls it.
        let caller = format!("{below}::State, {below}::Inputs, {below}::Outputs");
        callers += &format!(
            "\n#[inline(never)]\n#[must_use]\npub fn run_{below}((s, i, o): &mut ({caller})) -> u32 {{\n    \
             {below}::step(s, i, o);\n    {below}::self_test()\n}}\n"
        );
    }
    root += &callers;
    std::fs::write(folder.path().join("lib.rs"), root).unwrap();
    folder
}

/// What a program of the toolchain says of a crate; it must say nothing.
fn silent(program: &str, folder: &Path, arguments: &[&str]) {
    let output = Command::new(program).args(arguments).arg("lib.rs").current_dir(folder).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let said = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    assert!(output.status.success() && said.is_empty(), "{program} {}:\n{said}", arguments.join(" "));
}

/// Whether a part of the toolchain is there; a minimal one has neither, CI's must.
fn has_tool(program: &str, component: &str) -> bool {
    let is_there = said(program, "--version").is_some_and(|version| !version.is_empty());
    if !is_there {
        assert!(std::env::var_os("CI").is_none(), "{program} is not installed: rustup component add {component}");
        let _ = writeln!(std::io::stderr(), "NOT TESTED: {program} is not installed: rustup component add {component}");
    }
    is_there
}

const LIBRARY: [&str; 4] = ["--crate-type", "lib", "-D", "warnings"];

#[test]
fn no_edition_warns() {
    let axes = without_stages();
    let of_axes = axes.iter().flat_map(|axis| axis_files(axis, &[target::named("rust").unwrap()]).unwrap());
    let of_axes = of_axes.filter(|file| file.name.ends_with(".rs")).map(|file| vec![file]);
    let modules: Vec<Vec<File>> = in_both_real_types().iter().map(module).chain(of_axes).collect();
    let folder = library(&modules);
    for edition in ["2024", "2018", "2021"].into_iter().take(by_depth(1, 1, 3)) {
        let arguments = [&LIBRARY[..], &["--edition", edition, "--emit", "metadata"]].concat();
        silent(&rust::command(), folder.path(), &arguments);
    }
}

/// A crate's own `cargo fmt` would change a file that bears a checksum.
#[test]
fn the_toolchain_leaves_modules_as_they_are() {
    let modules: Vec<Vec<File>> = all().iter().step_by(by_depth(8, 4, 1)).map(module).collect();
    let folder = library(&modules);
    let library = |more: &[&'static str]| [&LIBRARY[..], more].concat();
    if has_tool("rustfmt", "rustfmt") {
        silent("rustfmt", folder.path(), &["--check", "--edition", "2021"]);
    }
    if has_tool("clippy-driver", "clippy") {
        silent(
            "clippy-driver",
            folder.path(),
            &library(&["--edition", "2021", "-W", "clippy::all", "-W", "clippy::pedantic", "--emit", "metadata"]),
        );
    }
    silent("rustdoc", folder.path(), &["--edition", "2021", "--crate-name", "modules", "-D", "warnings"]);
}

/// The example of each block: in a user's crate it is not run, because its path is another one.
#[test]
fn the_examples_of_the_documentation_run() {
    let mut of_blocks: BTreeMap<&str, Vec<File>> = BTreeMap::new();
    let cases = all();
    for case in &cases {
        of_blocks.entry(case.block.program.block).or_insert_with(|| module(case));
    }
    assert_eq!(of_blocks.len(), 8, "{:?}", of_blocks.keys());
    let mut modules: Vec<Vec<File>> = of_blocks.into_values().collect();
    for (number, files) in modules.iter_mut().enumerate() {
        let stem = files[0].name.trim_end_matches(".rs").to_owned();
        let text = files[0].text.replace("//! ```ignore\n", "//! ```\n");
        files[0].text = text.replace(&format!("use {stem}::{{"), &format!("use modules::m{number:03}::{{"));
    }
    let folder = library(&modules);
    let build = [&LIBRARY[..], &["--edition", "2021", "--crate-name", "modules"]].concat();
    silent(&rust::command(), folder.path(), &build);
    let arguments = ["--test", "--edition", "2021", "--crate-name", "modules", "-L", ".", "lib.rs"];
    let output = Command::new("rustdoc").args(arguments).current_dir(folder.path()).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && said.contains("8 passed; 0 failed;"), "{said}");
}

/// The symbols of the object that a build makes of modules, checked for overflow too.
fn symbols(modules: &[Vec<File>], more: &[&str]) -> Vec<String> {
    let folder = library(modules);
    let options = ["--edition", "2021", "-C", "overflow-checks=on", "-C", "panic=abort", "--emit", "obj=modules.o"];
    silent(&rust::command(), folder.path(), &[&LIBRARY[..], &options, more].concat());
    let output = Command::new("nm").args(["--format=posix", "modules.o"]).current_dir(folder.path()).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect()
}

/// Copies and clears that a compiler makes, and arithmetic of double precision where the processor has none: `core`
/// comes with both.
fn is_of_core(symbol: &str) -> bool {
    ["mem", "__aeabi_mem", "__aeabi_d", "__aeabi_f2d", "__aeabi_i2d", "__aeabi_ui2d"]
        .iter()
        .any(|start| symbol.starts_with(start))
}

/// What an unoptimised build calls where a remainder by -1 would overflow. Check words take remainders by constants alone.
const REMAINDER: &str = "panic_const_rem_overflow";

/// Nothing is called that could panic: neither by `step` nor by the self-test.
#[test]
fn no_module_can_panic() {
    if !has("nm", "nm", "binutils") {
        return;
    }
    // In a plain run an eighth of the cases.
    let modules: Vec<Vec<File>> = in_both_real_types().iter().step_by(by_depth(8, 4, 1)).map(module).collect();
    // optimised, and as a debugger likes it
    let mut builds = vec![vec!["-O"], vec!["-C", "debug-assertions=on"]];
    let arm = "thumbv7em-none-eabihf";
    let installed = Command::new(rust::command()).args(["--print", "target-libdir", "--target", arm]).output().unwrap();
    if Path::new(String::from_utf8_lossy(&installed.stdout).trim()).is_dir() {
        builds.push(vec!["-O", "--target", arm]);
    } else {
        let _ = writeln!(std::io::stderr(), "NOT TESTED: no core library for {arm}: rustup target add {arm}");
    }
    for build in builds {
        let mut symbols = symbols(&modules, &build);
        if !build.contains(&"-O") {
            symbols.retain(|symbol| !symbol.contains(REMAINDER));
        }
        let callers = symbols.iter().filter(|symbol| symbol.contains("run_m") && symbol.contains(" T "));
        assert_eq!(callers.count(), modules.len(), "{build:?}: {symbols:#?}");
        let undefined = symbols.iter().filter(|symbol| symbol.split_whitespace().nth(1) == Some("U"));
        let strange: Vec<&String> = undefined.filter(|symbol| !is_of_core(symbol)).collect();
        assert!(strange.is_empty(), "{build:?}: {strange:#?}");
        assert!(!symbols.iter().any(|symbol| symbol.contains("panic")), "{build:?}");
    }
    // That a panic would be seen.
    let mut divides = modules[0].clone();
    divides[0].text += "\n#[inline(never)]\npub fn divide(a: u32, b: u32) -> u32 {\n    a / b\n}\n";
    assert!(symbols(&[divides], &["-O"]).iter().any(|symbol| symbol.contains("panic")));
}

/// The texts in which one statement of `step` is another.
fn planted(text: &str, plant: fn(&str) -> Option<String>) -> Vec<String> {
    let start = text.find("pub fn step(").unwrap();
    let body = &text[start..start + text[start..].find("\n}\n").unwrap()];
    let changed = |statement| Some(text.replacen(statement, &plant(statement)?, 1));
    body.split_inclusive(';').filter_map(changed).collect()
}

/// `a - b * c` and `a + b * c` in one rounding, as a build with contraction would compute it.
fn fused(statement: &str) -> Option<String> {
    let (target, value) = statement.strip_suffix(';')?.split_once(" =")?;
    let words: Vec<&str> = value.split_whitespace().collect();
    let [a, sign, b, "*", c] = words[..] else { return None };
    let sign = match sign {
        "+" => "",
        "-" => "-",
        _ => return None,
    };
    Some(format!("{target} = ({sign}{b}).mul_add({c}, {a});"))
}

/// A state of a section that stays as it was; not where it is cleared, which finds it cleared in a new block.
fn lost(statement: &str) -> Option<String> {
    let (before, assigned) = statement.split_at(statement.find("state.stage")?);
    let is_of_section =
        before.rsplit('\n').next()?.trim().is_empty() && assigned.contains("_section") && !assigned.ends_with("= 0.0;");
    is_of_section.then(|| format!("{before}if false {{ {assigned} }}"))
}

/// A NaN taken for a number that is in range, as a build with finite arithmetic only would.
fn finite(text: &str) -> Vec<String> {
    let wrong = |text: String, input| {
        let asked = format!("inputs.{input}.abs() <= SAMPLE_LIMIT");
        text.replace(&asked, &format!("!(inputs.{input}.abs() > SAMPLE_LIMIT)"))
    };
    let wrong = ["v_command", "v_motor", "v_direct"].into_iter().fold(text.to_owned(), wrong);
    assert!(wrong != text);
    vec![wrong]
}

/// Each single one.
#[test]
fn the_self_test_finds_planted_faults() {
    let cases = ["rack-and-pinion, f64", "single-precision-highest-frequency, f32"];
    type Plant = fn(&str) -> Vec<String>;
    let plants: [(&str, Plant); 3] =
        [("fused", |text| planted(text, fused)), ("lost", |text| planted(text, lost)), ("finite", finite)];
    for case in in_both_real_types().iter().filter(|case| cases.contains(&title(case).as_str())) {
        let File { name, text } = &module(case)[0];
        let inputs = case::inputs(case, VECTOR_SAMPLES).unwrap();
        for (kind, plant) in plants {
            let is_found = |text: String| match rust::run_file(&File { name: name.clone(), text }, &case.block, &inputs)
            {
                Err(Failure::SelfTest(_)) => true,
                Ok(_) => false,
                Err(failure) => panic!("{}: {kind}: {failure}", title(case)),
            };
            let found: Vec<bool> = plant(text).into_par_iter().map(is_found).collect();
            let count = found.iter().filter(|found| **found).count();
            println!("{}: {kind}: {count} of {} found", title(case), found.len());
            assert!(count > 0 && count == found.len(), "{}: {kind}: {count} of {}", title(case), found.len());
        }
    }
}
