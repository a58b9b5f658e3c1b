//! The C and the Rust of a batch: compiled by the host's compilers and run, several units at a time.

use rayon::prelude::*;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What the compiler is asked for, next to the level: what contracts fuses, and what a user's build would not let pass.
const OPTIONS: [&str; 14] = [
    "-std=c99",
    "-ffp-contract=off",
    "-pedantic",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wfloat-equal",
    "-Werror",
    // What only random programs do: parameters that nothing reads, comparisons that are always true.
    "-Wno-unused-parameter",
    "-Wno-unused-function",
    "-Wno-type-limits",
    "-Wno-tautological-compare",
    "-Wno-float-equal",
];

/// A line of the driver, or an error of the compiler, about one program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// the program's number
    pub program: usize,
    /// the real type
    pub real: &'static str,
    /// the engine: `c -O2`, `rust -O`
    pub engine: String,
    /// what was found
    pub message: String,
}

/// Compiles and runs the units of a folder that begin with the programs of these numbers. All are compiled at -O2, the
/// first also at -O0 and as Rust.
///
/// # Errors
/// There is no compiler, or something breaks off that is not about one program.
pub fn run(folder: &Path, firsts: &[usize]) -> Result<Vec<Line>, String> {
    for (name, text) in [("driver.c", include_str!("driver.c")), ("driver.rs", include_str!("driver.rs"))] {
        fs::write(folder.join(name), text).map_err(|error| error.to_string())?;
    }
    let at =
        |level: &'static str| firsts.iter().flat_map(move |first| ["f64", "f32"].map(|real| (level, real, *first)));
    let mut units: Vec<_> = at("-O2").collect();
    units.extend(at("-O0").take(2));
    units.extend(at(RUST).take(2));
    let lines: Result<Vec<_>, String> = units
        .into_par_iter()
        .map(
            |(level, real, first)| {
                if level == RUST { rust_unit(folder, real, first) } else { unit(folder, level, real, first) }
            },
        )
        .collect();
    Ok(lines?.concat())
}

/// What stands for a level where Rust is compiled.
const RUST: &str = "rust -O";

fn rust_unit(folder: &Path, real: &'static str, first: usize) -> Result<Vec<Line>, String> {
    let (stem, program) = (format!("{real}_{first}"), format!("{real}_{first}_rust"));
    let source = format!("{stem}.rs");
    let compiler = golden::engine::rust::command();
    let output = Command::new(&compiler)
        .current_dir(folder)
        .args(["--edition", "2024", "-O", "--error-format", "short", &source, "-o", &program])
        .output()
        .map_err(|error| {
            format!("the Rust compiler `{compiler}` does not start ({error}): install it, or set RUSTC")
        })?;
    let line = |program, message| Line { program, real, engine: RUST.to_owned(), message };
    if !output.status.success() {
        return refused(folder, &source, &String::from_utf8_lossy(&output.stderr), line);
    }
    answers(folder, &program, &stem, line)
}

fn unit(folder: &Path, level: &str, real: &'static str, first: usize) -> Result<Vec<Line>, String> {
    let stem = format!("{real}_{first}");
    let program = format!("{stem}{level}");
    let (c_name, bits) = if real == "f64" { ("double", "uint64_t") } else { ("float", "uint32_t") };
    let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
    let output = Command::new(&compiler)
        .current_dir(folder)
        .args(OPTIONS)
        .args([level, "driver.c", "-o", &program])
        .args([format!("-DUNIT=\"{stem}.c\""), format!("-DREAL={c_name}"), format!("-DBITS={bits}")])
        .output()
        .map_err(|error| format!("the C compiler `{compiler}` does not start ({error}): install it, or set CC"))?;
    let line = |program, message| Line { program, real, engine: format!("c {level}"), message };
    if !output.status.success() {
        return refused(folder, &format!("{stem}.c"), &String::from_utf8_lossy(&output.stderr), line);
    }
    answers(folder, &program, &stem, line)
}

/// The programs that a compiler's errors are about.
fn refused(folder: &Path, file: &str, errors: &str, line: impl Fn(usize, String) -> Line) -> Result<Vec<Line>, String> {
    let source = fs::read_to_string(folder.join(file)).unwrap_or_default();
    let place = format!("{file}:");
    let of_error = |error: &str| Some(line(about(error, &place, &source)?, error.to_owned()));
    let found: Vec<Line> = errors.lines().filter_map(of_error).collect();
    if found.is_empty() { Err(format!("{file} does not compile:\n{errors}")) } else { Ok(found) }
}

/// Runs what was compiled on its words.
fn answers(
    folder: &Path,
    program: &str,
    stem: &str,
    line: impl Fn(usize, String) -> Line,
) -> Result<Vec<Line>, String> {
    let output = Command::new(folder.join(program))
        .current_dir(folder)
        .arg(format!("{stem}.words"))
        .output()
        .map_err(|error| format!("{program} does not start: {error}"))?;
    let answers = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() || !answers.ends_with("programs have run\n") {
        return Err(format!("{program} broke off ({}): {answers}", output.status));
    }
    let differences = answers.lines().filter_map(|answer| answer.split_once('\t'));
    Ok(differences.map(|(program, message)| line(program.parse().unwrap_or(usize::MAX), message.to_owned())).collect())
}

/// The number of the program that an error of the compiler is about.
fn about(error: &str, place: &str, source: &str) -> Option<usize> {
    let at: usize = error.split_once(place)?.1.split(':').next()?.parse().ok()?;
    (error.contains("error:") || error.contains("error[")).then_some(())?;
    let marks = source.lines().take(at).filter_map(|line| line.strip_prefix("/* program "));
    marks.last()?.strip_suffix(" */")?.parse().ok()
}
