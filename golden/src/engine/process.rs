//! A compiled block as a process: samples on its standard input, answers on its standard output. The compiler is not known
//! here.

use super::Failure;
use crate::samples::{Samples, Shape};
use compiler::program::Variable;
use generator::blocks::Block;
use portable::RealKind;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// A temporary folder.
pub(super) fn folder() -> Result<TempDir, Failure> {
    tempfile::tempdir().map_err(|error| Failure::Environment(format!("no temporary folder: {error}")))
}

/// Writes a file to be compiled.
pub(super) fn write(folder: &Path, name: &str, text: &str) -> Result<(), Failure> {
    let written = std::fs::write(folder.join(name), text);
    written.map_err(|error| Failure::Environment(format!("{name}: {error}")))
}

/// The bytes of a sample of these variables.
pub(super) fn frame(variables: &[Variable], real: RealKind) -> usize {
    Shape::of(variables, real).frame()
}

/// Runs the program of a block from its start, with arguments.
pub(super) fn run(program: &str, arguments: &[String], block: &Block, inputs: &Samples) -> Result<Samples, Failure> {
    let (all, for_axis) = (&block.program, &block.for_axis);
    let bytes = pipe(program, arguments, &inputs.only(&for_axis.inputs).bytes)?;
    let shape = Shape::of(&for_axis.program.outputs, all.real);
    if bytes.len() != shape.frame() * inputs.len() {
        return Err(Failure::Broken(format!("{} bytes came out for {} samples", bytes.len(), inputs.len())));
    }
    Ok(Samples { shape, bytes }.among(&for_axis.outputs, &Shape::of(&all.outputs, all.real)))
}

/// Runs the program with the samples on its standard input.
fn pipe(program: &str, arguments: &[String], input: &[u8]) -> Result<Vec<u8>, Failure> {
    let broken = |what: &str, error: &std::io::Error| Failure::Broken(format!("{what} the compiled block: {error}"));
    let mut child = Command::new(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| broken("starting", &error))?;
    let mut stdin = child.stdin.take().expect("engine: standard input is piped");
    let mut stdout = child.stdout.take().expect("engine: standard output is piped");
    let mut output = Vec::with_capacity(input.len());
    let read = std::thread::scope(|scope| {
        // A block that fails its self-test reads nothing, so a broken input pipe is not another failure.
        scope.spawn(move || drop(stdin.write_all(input)));
        stdout.read_to_end(&mut output)
    });
    let result = child.wait_with_output().map_err(|error| broken("waiting for", &error))?;
    read.map_err(|error| broken("reading from", &error))?;
    match result.status.code() {
        Some(0) => Ok(output),
        Some(2) => Err(Failure::SelfTest(String::from_utf8_lossy(&result.stderr).trim().parse().unwrap_or_default())),
        other => Err(Failure::Broken(format!("the compiled block ended with {other:?}"))),
    }
}
