//! The engine `rust`: the emitted module, compiled by a Rust compiler and run as a process.

use super::compiler::call;
use super::{Failure, process};
use crate::samples::Samples;
use compiler::print::rust::LANGUAGE;
use compiler::print::signals;
use compiler::program::{Type, Variable};
use generator::blocks::{Block, Designed};
use generator::target::File;
use portable::RealKind;
use std::fmt::Write;
use std::path::Path;

/// The host's compiler: `$RUSTC` or `rustc`.
#[must_use]
pub fn command() -> String {
    std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned())
}

/// The options of a user's release build; a warning about the module is a defect of it.
const OPTIONS: [&str; 8] = ["--edition", "2024", "-O", "-D", "warnings", "harness.rs", "-o", "block"];

/// Compiles and runs a block from the file that its target emits.
pub(super) fn run(designed: &Designed, block: &Block, inputs: &Samples) -> Result<Samples, Failure> {
    let files = super::files(super::target("rust"), designed, block)?;
    let [file] = files.as_slice() else { return Err(Failure::Broken("a module is one file".to_owned())) };
    run_with(file, &super::of_set(super::target("rust"), designed, block)?, block, inputs)
}

/// Compiles and runs a block from its module.
///
/// # Errors
/// The compiler is missing or rejects the module, or the block fails its self-test.
pub fn run_file(file: &File, block: &Block, inputs: &Samples) -> Result<Samples, Failure> {
    run_with(file, &[], block, inputs)
}

/// Compiles and runs a block from its module, with the modules that it uses.
fn run_with(file: &File, used: &[File], block: &Block, inputs: &Samples) -> Result<Samples, Failure> {
    let folder = process::folder()?;
    write(folder.path(), file, used, block)?;
    call("Rust", "RUSTC", &command(), folder.path(), &OPTIONS)?;
    process::run(&folder.path().join("block").to_string_lossy(), &[], block, inputs)
}

/// Runs many blocks in one program, compiled once; returns the outputs of each.
///
/// # Errors
/// The compiler is missing or rejects a module, or a block fails its self-test.
pub fn run_files(many: &[(&File, &Block, &Samples)]) -> Result<Vec<Samples>, Failure> {
    let folder = process::folder()?;
    let (mut modules, mut arms) = (String::new(), String::new());
    for (number, (file, block, _)) in many.iter().enumerate() {
        let below = folder.path().join(format!("m{number}"));
        std::fs::create_dir(&below).map_err(|error| Failure::Environment(format!("{}: {error}", below.display())))?;
        write(&below, file, &[], block)?;
        writeln!(modules, "#[path = \"m{number}/harness.rs\"]\nmod m{number};")
            .expect("engine: a string takes all text");
        writeln!(arms, "        Some(\"{number}\") => m{number}::main(),").expect("engine: a string takes all text");
    }
    let main = format!(
        "{modules}fn main() -> std::process::ExitCode {{\n    match std::env::args().nth(1).as_deref() {{\n{arms}        \
         _ => std::process::ExitCode::from(4),\n    }}\n}}\n"
    );
    process::write(folder.path(), "main.rs", &main)?;
    let options = ["--edition", "2024", "-C", "opt-level=1", "-D", "warnings", "main.rs", "-o", "blocks"];
    call("Rust", "RUSTC", &command(), folder.path(), &options)?;
    let program = folder.path().join("blocks").to_string_lossy().into_owned();
    let run = |(number, (_, block, inputs)): (usize, &(&File, &Block, &Samples))| {
        process::run(&program, &[number.to_string()], block, inputs)
    };
    many.iter().enumerate().map(run).collect()
}

/// Writes a module, and the program that runs it.
fn write(folder: &Path, file: &File, used: &[File], block: &Block) -> Result<(), Failure> {
    let declared = used.iter().map(|file| {
        let module = file.name.trim_end_matches(".rs");
        format!("#[allow(dead_code)]\n#[path = \"{}\"]\nmod {module};\n", file.name)
    });
    let layout = declared.collect::<String>() + &layout(&file.name, block);
    let texts = [("layout.rs", layout.as_str()), ("harness.rs", include_str!("harness.rs"))];
    let modules = used.iter().chain([file]).map(|file| (file.name.as_str(), file.text.as_str()));
    texts.into_iter().chain(modules).try_for_each(|(name, text)| process::write(folder, name, text))
}

/// The description of the block for the harness.
fn layout(file: &str, block: &Block) -> String {
    let program = &block.for_axis.program;
    let real = program.real;
    let [inputs, outputs] = signals(program, &LANGUAGE);
    let frame = |variables| process::frame(variables, real);
    format!(
        "#[path = \"{file}\"]\nmod block;\nconst IN_FRAME: usize = {};\nconst OUT_FRAME: usize = {};\n\
         fn get(frame: &[u8; IN_FRAME], inputs: &mut block::Inputs) {{\n{}}}\n\
         fn put(outputs: &block::Outputs, frame: &mut [u8; OUT_FRAME]) {{\n{}}}\n",
        frame(&program.inputs),
        frame(&program.outputs),
        each(&program.inputs, &inputs, real, |name, ty, bytes| match ty {
            None => format!("inputs.{name} = frame[{}] != 0;", bytes.start),
            Some(ty) => format!(
                "inputs.{name} = {ty}::from_ne_bytes(frame[{}..{}].try_into().unwrap());",
                bytes.start, bytes.end
            ),
        }),
        each(&program.outputs, &outputs, real, |name, ty, bytes| match ty {
            None => format!("frame[{}] = u8::from(outputs.{name});", bytes.start),
            // A real of a parameter set may be of single precision in a block of double precision.
            Some("f64") => format!(
                "frame[{}..{}].copy_from_slice(&f64::from(outputs.{name}).to_ne_bytes());",
                bytes.start, bytes.end
            ),
            Some(_) => {
                format!("frame[{}..{}].copy_from_slice(&outputs.{name}.to_ne_bytes());", bytes.start, bytes.end)
            }
        }),
    )
}

/// A statement for each variable: its name, its type unless it is a BOOL, and its bytes in a frame.
fn each(
    variables: &[Variable],
    names: &[String],
    real: RealKind,
    statement: impl Fn(&str, Option<&str>, std::ops::Range<usize>) -> String,
) -> String {
    let (mut text, mut start) = (String::new(), 0);
    for (variable, name) in variables.iter().zip(names) {
        let end = start + process::frame(std::slice::from_ref(variable), real);
        let ty = (variable.ty != Type::Bool).then(|| LANGUAGE.ty(variable.ty, real));
        writeln!(text, "    {}", statement(name, ty, start..end)).expect("engine: a string takes all text");
        start = end;
    }
    text
}
