//! Runs programs: writes crates that contain them, has them built, and gathers what they, their C and their Rust say.

use super::syntax::Program;
use super::{compile, print, structured_text};
use inside::defect::{self, Defect};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Programs of a crate: few enough for the memory of one compiler, enough to keep the others at work.
const SHARD: usize = 125;

/// What is to be run, and how.
#[derive(Clone, Debug)]
pub struct Batch<'b> {
    /// a folder that is kept from run to run, so that what has not changed is not built again
    pub folder: &'b Path,
    /// what the crates are called
    pub name: &'b str,
    /// the programs, each with the name that its inputs are made from
    pub programs: Vec<(String, &'b Program)>,
    /// the real types: `f64`, `f32`
    pub reals: &'b [&'static str],
    /// what is planted
    pub defect: Option<Defect>,
    /// whether the C and the Rust are compiled and run, and the Structured Text too
    pub with_text: bool,
}

/// What came of a program.
#[derive(Clone, Debug, Default)]
pub struct Answer {
    /// the engines that differ
    pub differences: Vec<Difference>,
    /// what the run had in it
    pub facts: BTreeSet<String>,
    /// why rustc does not take it
    pub rejected: Option<String>,
}

/// An engine that differs from the Rust itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// the real type
    pub real: String,
    /// the pass after which the interpreted program differs, `c` or `rust` with its level, or `st`
    pub engine: String,
    /// what was found
    pub message: String,
}

/// Runs the programs.
///
/// # Errors
/// The crates cannot be built for a reason that is not one of the programs, or something breaks off.
pub fn run(batch: &Batch<'_>) -> Result<Vec<Answer>, String> {
    let mut answers = vec![Answer::default(); batch.programs.len()];
    let crates = batch.folder.join(batch.name);
    // What rustc rejects is left out; each round of errors may hide further ones.
    loop {
        let kept: Vec<usize> = (0..answers.len()).filter(|number| answers[*number].rejected.is_none()).collect();
        let shards: Vec<&[usize]> = kept.chunks(SHARD).collect();
        write_crates(batch, &crates, &shards).map_err(|error| format!("{}: {error}", crates.display()))?;
        match build(batch, &crates, shards.len()) {
            Ok(binary) => {
                gather(&binary, batch, &shards, &crates.join("c"), &mut answers)?;
                return Ok(answers);
            }
            Err(errors) => {
                let rejected = rejected(&errors);
                if rejected.is_empty() {
                    return Err(errors);
                }
                for (number, error) in rejected {
                    answers[number].rejected = Some(error);
                }
            }
        }
    }
}

/// Writes the workspace: a crate for each shard, and one that runs them all.
fn write_crates(batch: &Batch<'_>, crates: &Path, shards: &[&[usize]]) -> std::io::Result<()> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = tests.parent().unwrap_or(tests);
    let dependency = |name: &str, package: &str, path: PathBuf| {
        format!("{name} = {{ package = \"{package}\", path = {:?} }}\n", path.display().to_string())
    };
    let dependencies = dependency("portable", "axgen-portable", root.join("reference/portable"))
        + &dependency("inside", "axgen-inside", root.join("tests/inside"));
    let package = |name: &str, dependencies: &str| {
        format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n\
             [dependencies]\n{dependencies}"
        )
    };
    let names = shard_names(batch, shards.len());
    let (mut members, mut needs, mut calls) = (String::new(), dependencies.clone(), String::new());
    for (name, shard) in names.iter().zip(shards) {
        let _ = write!(members, "\"{name}\", ");
        let _ = writeln!(needs, "{name} = {{ path = \"../{name}\" }}");
        let _ = write!(calls, "{name}::instances, ");
        write(&crates.join(name).join("Cargo.toml"), &package(name, &dependencies))?;
        write(&crates.join(name).join("src/lib.rs"), &shard_source(batch, shard))?;
        for number in *shard {
            let (inputs, program) = &batch.programs[*number];
            write(&crates.join(name).join(format!("src/p{number}.rs")), &print::module(program, inputs))?;
        }
    }
    let manifest = format!("[workspace]\nresolver = \"3\"\nmembers = [{members}\"run\"]\n\n{PROFILE}");
    write(&crates.join("Cargo.toml"), &manifest)?;
    // The binary's name is the batch's: all batches share one folder for what cargo makes.
    write(&crates.join("run/Cargo.toml"), &package(batch.name, &needs))?;
    write(&crates.join("run/src/main.rs"), &format!("fn main() {{\n    inside::worker::main(&[{calls}]);\n}}\n"))?;
    fs::create_dir_all(crates.join("c"))?;
    let lock = crates.join("Cargo.lock");
    if lock.exists() { Ok(()) } else { fs::copy(root.join("Cargo.lock"), lock).map(|_| ()) }
}

/// The names of the crates. To cargo two crates of one name at one place below two workspaces are one, and all batches share a
/// folder for what it makes: without the batch in its name a crate would be taken for another batch's.
fn shard_names(batch: &Batch<'_>, count: usize) -> Vec<String> {
    (0..count).map(|shard| format!("{}_shard{shard}", batch.name.replace('-', "_"))).collect()
}

/// The programs are built fast and run once; what builds and runs them is worth optimising. Integers wrap in them.
const PROFILE: &str = "[profile.dev]\nopt-level = 0\ndebug = false\noverflow-checks = false\ndebug-assertions = false\n\
                       incremental = false\n\n[profile.dev.package.\"*\"]\nopt-level = 1\n";

fn shard_source(batch: &Batch<'_>, shard: &[usize]) -> String {
    let mut modules = String::from("#![allow(warnings, arithmetic_overflow, unconditional_panic)]\n");
    let mut instances = String::new();
    for number in shard {
        let _ = writeln!(modules, "mod p{number};");
        for real in batch.reals {
            let _ = writeln!(instances, "        ({number}, instance::<{real}, p{number}::Subject>()),");
        }
    }
    format!(
        "{modules}\nuse inside::subject::{{Instance, instance}};\n\n\
         pub fn instances() -> Vec<(usize, Instance)> {{\n    vec![\n{instances}    ]\n}}\n"
    )
}

/// Writes a file, unless it is there already: what has not changed is not built again.
fn write(path: &Path, text: &str) -> std::io::Result<()> {
    if fs::read(path).is_ok_and(|old| old == text.as_bytes()) {
        return Ok(());
    }
    fs::create_dir_all(path.parent().unwrap_or(path))?;
    fs::write(path, text)
}

/// Builds the crates; gives the binary, or the errors. With the libraries that the tests were built with, if `AXGEN_LIBRARIES` names
/// them (`name=path`, one a line); else cargo builds those too.
fn build(batch: &Batch<'_>, crates: &Path, shards: usize) -> Result<PathBuf, String> {
    match std::env::var("AXGEN_LIBRARIES") {
        Ok(libraries) => build_with(&libraries, batch, crates, shards),
        Err(_) => build_all(batch, crates),
    }
}

fn build_with(libraries: &str, batch: &Batch<'_>, crates: &Path, shards: usize) -> Result<PathBuf, String> {
    let out = batch.folder.join("built");
    fs::create_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    let compile = |name: &str, kind: &str, source: PathBuf, shards: &[String]| -> Result<(), String> {
        let mut rustc = Command::new(std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned()));
        rustc.args(["--edition=2024", "--error-format=short", "-Coverflow-checks=off", "--crate-name", name]);
        rustc.args(["--crate-type", kind]).arg(source).arg("--out-dir").arg(&out).arg("-L").arg(&out);
        for library in libraries.lines() {
            let folder = library.split_once('=').and_then(|(_, path)| Path::new(path).parent());
            rustc.args(["--extern", library]).arg("-L").arg(folder.unwrap_or(&out));
        }
        for shard in shards {
            rustc.args(["--extern", shard]);
        }
        let output = rustc.output().map_err(|error| format!("rustc does not start: {error}"))?;
        let is_built = output.status.success();
        if is_built { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned()) }
    };
    let names = shard_names(batch, shards);
    let build = |name: &String| compile(name, "rlib", crates.join(name).join("src/lib.rs"), &[]).err();
    let errors: String = names.par_iter().filter_map(build).collect();
    if !errors.is_empty() {
        return Err(errors);
    }
    let name = batch.name.replace('-', "_");
    compile(&name, "bin", crates.join("run/src/main.rs"), &names)?;
    Ok(out.join(format!("{name}{}", std::env::consts::EXE_SUFFIX)))
}

fn build_all(batch: &Batch<'_>, crates: &Path) -> Result<PathBuf, String> {
    let target = batch.folder.join("target");
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo)
        .args(["build", "--offline", "--quiet", "--keep-going", "--message-format", "short", "--manifest-path"])
        .arg(crates.join("Cargo.toml"))
        .arg("--target-dir")
        .arg(&target)
        .output()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    if output.status.success() {
        return Ok(target.join("debug").join(format!("{}{}", batch.name, std::env::consts::EXE_SUFFIX)));
    }
    Err(String::from_utf8_lossy(&output.stderr).into_owned())
}

/// The programs that rustc's errors are about, each with the first error.
fn rejected(errors: &str) -> BTreeMap<usize, String> {
    let mut rejected = BTreeMap::new();
    for line in errors.lines().filter(|line| line.contains(": error")) {
        let file = line.split_once("/src/p").and_then(|(_, rest)| rest.split_once(".rs:"));
        if let Some(number) = file.and_then(|(number, _)| number.parse().ok()) {
            rejected.entry(number).or_insert_with(|| line.to_owned());
        }
    }
    rejected
}

/// Runs the binary, then the C, and gathers the answers.
fn gather(
    binary: &Path,
    batch: &Batch<'_>,
    shards: &[&[usize]],
    folder: &Path,
    answers: &mut [Answer],
) -> Result<(), String> {
    let mut command = Command::new(binary);
    command.arg(folder).args(batch.defect.map(defect::name));
    let output = command.output().map_err(|error| format!("{}: {error}", binary.display()))?;
    let text = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() {
        return Err(format!("{} broke off: {}", binary.display(), String::from_utf8_lossy(&output.stderr)));
    }
    let mut ran = vec![0; answers.len()];
    for line in text.lines() {
        let fields: Vec<&str> = line.split('\t').collect();
        let Some(answer) = fields.get(1).and_then(|number| answers.get_mut(number.parse::<usize>().ok()?)) else {
            return Err(format!("{} says `{line}`", binary.display()));
        };
        match fields[..] {
            ["differs", _, real, engine, message] => answer.differences.push(difference(real, engine, message)),
            ["facts", number, ..] => {
                ran[number.parse::<usize>().map_err(|error| error.to_string())?] += 1;
                answer.facts.extend(fields[2..].iter().filter(|fact| !fact.is_empty()).map(|fact| (*fact).to_owned()));
            }
            _ => return Err(format!("{} says `{line}`", binary.display())),
        }
    }
    if let Some(number) = shards.concat().into_iter().find(|number| ran[*number] != batch.reals.len()) {
        return Err(format!("{} ran program {number} {} times", binary.display(), ran[number]));
    }
    if batch.with_text {
        let firsts: Vec<usize> = shards.iter().filter_map(|shard| shard.first().copied()).collect();
        for line in compile::run(folder, &firsts)?.into_iter().chain(structured_text::run(folder, &firsts)?) {
            let answer =
                answers.get_mut(line.program).ok_or_else(|| format!("an engine names program {}", line.program))?;
            answer.differences.push(difference(line.real, &line.engine, &line.message));
        }
    }
    Ok(())
}

fn difference(real: &str, engine: &str, message: &str) -> Difference {
    Difference { real: real.to_owned(), engine: engine.to_owned(), message: message.to_owned() }
}
