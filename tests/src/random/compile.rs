//! The C of a batch: compiled by the host's compiler and run, several units at a time.

use rayon::prelude::*;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What the compiler is asked for, beside the level: what contracts fuses, and what a user's build would not let pass.
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
    /// the engine: `c -O2`
    pub engine: String,
    /// what was found
    pub message: String,
}

/// Compiles and runs the units of a folder that begin with the programs of these numbers. All are compiled at -O2, the
/// first also at -O0.
///
/// # Errors
/// There is no compiler, or something breaks off that is not about one program.
pub fn run(folder: &Path, firsts: &[usize]) -> Result<Vec<Line>, String> {
    fs::write(folder.join("driver.c"), include_str!("driver.c")).map_err(|error| error.to_string())?;
    let at =
        |level: &'static str| firsts.iter().flat_map(move |first| ["f64", "f32"].map(|real| (level, real, *first)));
    let mut units: Vec<_> = at("-O2").collect();
    units.extend(at("-O0").take(2));
    let lines: Result<Vec<_>, String> =
        units.into_par_iter().map(|(level, real, first)| unit(folder, level, real, first)).collect();
    Ok(lines?.concat())
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
        let errors = String::from_utf8_lossy(&output.stderr);
        let source = fs::read_to_string(folder.join(format!("{stem}.c"))).unwrap_or_default();
        let found: Vec<Line> = errors
            .lines()
            .filter_map(|error| Some(line(about(error, &format!("{stem}.c:"), &source)?, error.to_owned())))
            .collect();
        return if found.is_empty() { Err(format!("{stem}.c does not compile:\n{errors}")) } else { Ok(found) };
    }
    let output = Command::new(folder.join(&program))
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
    error.contains("error:").then_some(())?;
    let marks = source.lines().take(at).filter_map(|line| line.strip_prefix("/* program "));
    marks.last()?.strip_suffix(" */")?.parse().ok()
}
