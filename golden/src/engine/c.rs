//! The engine `c`: the emitted files, compiled by a C compiler and run as a process.

use super::{Compiler, Failure};
use crate::samples::{Samples, Shape};
use compiler::print::c::LANGUAGE;
use compiler::print::signals;
use compiler::program::{Type, Variable};
use generator::blocks::{Block, Designed};
use std::fmt::Write as _;
use std::io::{Read, Write};
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// A block's emitted files in a folder of their own, with a program around them that every build shares.
pub struct Harness {
    folder: TempDir,
    /// the emitted files to compile: the block, its self-test
    sources: Vec<String>,
    block: Block,
}

impl Harness {
    /// Writes the files of a block and compiles the program around it.
    ///
    /// # Errors
    /// The compiler is not there, or there is no room.
    pub fn compile(designed: &Designed, block: &Block, compiler: &Compiler) -> Result<Self, Failure> {
        let folder = new_folder()?;
        let write = |name: &str, text: &str| {
            let written = std::fs::write(folder.path().join(name), text);
            written.map_err(|error| Failure::Environment(format!("{name}: {error}")))
        };
        let emitted = super::files(super::target("c"), designed, block)?;
        for file in &emitted {
            write(&file.name, &file.text)?;
        }
        let stem = emitted.first().and_then(|file| file.name.strip_suffix(".h")).unwrap_or_default();
        write("layout.h", &layout(stem, block))?;
        write("harness.c", include_str!("harness.c"))?;
        let harness = ["-std=c99", "-O2", "-DLAYOUT=\"layout.h\"", "-c", "harness.c", "-o", "harness.o"];
        compiler.call(folder.path(), &harness, &[])?;
        let sources = emitted.iter().map(|file| &file.name).filter(|name| name.ends_with(".c")).cloned().collect();
        Ok(Self { folder, sources, block: block.clone() })
    }

    /// Compiles the block, only it with the compiler's options, and runs it.
    ///
    /// # Errors
    /// The compiler refuses, or the block does not pass its self-test.
    pub fn run(&self, inputs: &Samples, compiler: &Compiler) -> Result<Samples, Failure> {
        let build = new_folder()?;
        let path = |name: &str| build.path().join(name).to_string_lossy().into_owned();
        let program = path("block");
        let in_folder = |name: &str| self.folder.path().join(name).to_string_lossy().into_owned();
        let sources: Vec<String> = self.sources.iter().map(|name| in_folder(name)).collect();
        let objects = self.sources.iter().map(|name| name.trim_end_matches('c').to_owned() + "o");
        let objects: Vec<String> = objects.chain([in_folder("harness.o")]).collect();
        let compile: Vec<&str> = ["-c"].into_iter().chain(sources.iter().map(String::as_str)).collect();
        compiler.call(build.path(), &compile, &compiler.options)?;
        let link: Vec<&str> = ["-o", &program].into_iter().chain(objects.iter().map(String::as_str)).collect();
        compiler.call(build.path(), &link, &compiler.link)?;
        let (all, own) = (&self.block.program, &self.block.own);
        let bytes = pipe(&program, &compiler.emulator, &inputs.only(&own.inputs).bytes)?;
        let shape = Shape::of(&own.program.outputs, all.real);
        if bytes.len() != shape.frame() * inputs.len() {
            return Err(Failure::Broken(format!("{} bytes came out for {} samples", bytes.len(), inputs.len())));
        }
        Ok(Samples { shape, bytes }.among(&own.outputs, &Shape::of(&all.outputs, all.real)))
    }
}

fn new_folder() -> Result<TempDir, Failure> {
    tempfile::tempdir().map_err(|error| Failure::Environment(format!("no temporary folder: {error}")))
}

/// What the harness has to know of the block.
fn layout(stem: &str, block: &Block) -> String {
    let program = &block.own.program;
    let real = program.real;
    let [inputs, outputs] = signals(program, &LANGUAGE);
    let access = |verb: &str, variables: &[Variable], names: &[String]| {
        variables.iter().zip(names).fold(String::new(), |mut text, (variable, name)| {
            let written = match variable.ty {
                Type::Bool => write!(text, " {verb}_BOOL({name})"),
                ty => write!(text, " {verb}({}, {name})", LANGUAGE.ty(ty, real)),
            };
            written.expect("engine: a string takes all text");
            text
        })
    };
    let frame = |variables: &[Variable]| Shape::of(variables, real).frame();
    format!(
        "#include \"{stem}.h\"\n#define BLOCK(name) {stem}_##name\n#define IN_FRAME {}\n#define OUT_FRAME {}\n\
         #define GET_INPUTS{}\n#define PUT_OUTPUTS{}\n",
        frame(&program.inputs),
        frame(&program.outputs),
        access("GET", &program.inputs, &inputs),
        access("PUT", &program.outputs, &outputs),
    )
}

/// Runs the program with the samples on its standard input.
fn pipe(program: &str, emulator: &[String], input: &[u8]) -> Result<Vec<u8>, Failure> {
    let broken = |what: &str, error: &std::io::Error| Failure::Broken(format!("{what} the compiled block: {error}"));
    let words: Vec<&str> = emulator.iter().map(String::as_str).chain([program]).collect();
    let mut child = Command::new(words[0])
        .args(&words[1..])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| broken("starting", &error))?;
    let mut stdin = child.stdin.take().expect("engine: standard input is piped");
    let mut stdout = child.stdout.take().expect("engine: standard output is piped");
    let mut output = Vec::with_capacity(input.len());
    let read = std::thread::scope(|scope| {
        // A block that fails its self-test reads nothing: that its input breaks off is no failure of its own.
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
