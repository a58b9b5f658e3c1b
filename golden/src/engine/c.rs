//! The engine `c`: the emitted files, compiled by a C compiler and run as a process.

use super::Failure;
use crate::samples::{Samples, Shape};
use generator::axis::Axis;
use generator::block::Block;
use generator::program::Type;
use generator::target::c::{files, names, types};
use std::fmt::Write as _;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Command, Stdio};

/// A C compiler with its options.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compiler {
    /// the command
    pub command: String,
    /// its options
    pub options: Vec<String>,
}

impl Compiler {
    /// The host's compiler, as a user would call it: `$CC` or `cc`, `-std=c99 -O2`.
    #[must_use]
    pub fn host() -> Self {
        let command = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
        Self::new(&command, &["-O2"])
    }

    /// A compiler by name, with `-std=c99` and further options.
    #[must_use]
    pub fn new(command: &str, options: &[&str]) -> Self {
        let options = ["-std=c99"].iter().chain(options).map(|option| (*option).to_owned()).collect();
        Self { command: command.to_owned(), options }
    }
}

/// Runs a block.
pub fn run(axis: &Axis, block: &Block, inputs: &Samples, compiler: &Compiler) -> Result<Samples, Failure> {
    let folder = tempfile::tempdir().map_err(|error| Failure::Environment(format!("no temporary folder: {error}")))?;
    compile(axis, block, compiler, folder.path())?;
    let shape = Shape::of(&block.program.outputs, block.program.real);
    let bytes = pipe(&folder.path().join("harness"), &inputs.bytes)?;
    if bytes.len() != shape.frame() * inputs.len() {
        return Err(Failure::Broken(format!("{} bytes came out for {} samples", bytes.len(), inputs.len())));
    }
    Ok(Samples { shape, bytes })
}

/// Writes the emitted files and the harness, and compiles them: the block with the options, the harness without.
fn compile(axis: &Axis, block: &Block, compiler: &Compiler, folder: &Path) -> Result<(), Failure> {
    let write = |name: &str, text: &str| {
        std::fs::write(folder.join(name), text).map_err(|error| Failure::Environment(format!("{name}: {error}")))
    };
    let emitted = files(axis, std::slice::from_ref(block));
    for file in &emitted {
        write(&file.name, &file.text)?;
    }
    let stem = emitted.first().and_then(|file| file.name.strip_suffix(".h")).unwrap_or_default();
    write("layout.h", &layout(stem, block))?;
    write("harness.c", include_str!("harness.c"))?;
    let source = format!("{stem}.c");
    call(compiler, folder, &["-c", &source, "-o", "block.o"], true)?;
    call(compiler, folder, &["-DLAYOUT=\"layout.h\"", "harness.c", "block.o", "-o", "harness"], false)
}

fn call(compiler: &Compiler, folder: &Path, arguments: &[&str], with_options: bool) -> Result<(), Failure> {
    let mut command = Command::new(&compiler.command);
    command.current_dir(folder).args(arguments);
    if with_options {
        command.args(&compiler.options);
    } else {
        command.args(["-std=c99", "-O2"]);
    }
    let output = command.output().map_err(|error| {
        let name = &compiler.command;
        Failure::Environment(format!(
            "the C compiler `{name}` does not start ({error}); install it, or set CC to another"
        ))
    })?;
    if output.status.success() {
        return Ok(());
    }
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(if errors.contains("this block needs") { Failure::Refused(errors) } else { Failure::Broken(errors) })
}

/// What the harness has to know of the block.
fn layout(stem: &str, block: &Block) -> String {
    let program = &block.program;
    let (prefix, real) = (format!("{stem}_{}", program.block), program.real);
    let access = |verb: &str, variables: &[generator::program::Variable]| {
        variables.iter().fold(String::new(), |mut text, variable| {
            let name = names::identifier(&variable.path);
            let written = match variable.ty {
                Type::Bool => write!(text, " {verb}_BOOL({name})"),
                ty => write!(text, " {verb}({}, {name})", types::name(ty, real)),
            };
            written.expect("engine: a string takes all text");
            text
        })
    };
    let frame = |variables: &[generator::program::Variable]| Shape::of(variables, real).frame();
    format!(
        "#include \"{stem}.h\"\n#define BLOCK(name) {prefix}_##name\n#define IN_FRAME {}\n#define OUT_FRAME {}\n\
         #define GET_INPUTS{}\n#define PUT_OUTPUTS{}\n",
        frame(&program.inputs),
        frame(&program.outputs),
        access("GET", &program.inputs),
        access("PUT", &program.outputs),
    )
}

/// Runs the harness with the samples on its standard input.
fn pipe(harness: &Path, input: &[u8]) -> Result<Vec<u8>, Failure> {
    let broken = |what: &str, error: &std::io::Error| Failure::Broken(format!("{what} the compiled block: {error}"));
    let mut child = Command::new(harness)
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
