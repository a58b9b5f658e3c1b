//! The engine `c`: the emitted files, compiled by a C compiler and run as a process.

use super::{Compiler, Failure, process};
use crate::samples::Samples;
use compiler::print::c::LANGUAGE;
use compiler::print::signals;
use compiler::program::{Type, Variable};
use generator::blocks::{Block, Designed};
use std::fmt::Write as _;
use tempfile::TempDir;

/// A block's emitted files in a separate folder, with a surrounding program that every build shares.
pub struct Harness {
    folder: TempDir,
    /// the emitted files to compile: the block, its self-test
    sources: Vec<String>,
    block: Block,
}

impl Harness {
    /// Writes the files of a block and compiles the surrounding program.
    ///
    /// # Errors
    /// The compiler is missing, or the disk is full.
    pub fn compile(designed: &Designed, block: &Block, compiler: &Compiler) -> Result<Self, Failure> {
        let folder = process::folder()?;
        let write = |name: &str, text: &str| process::write(folder.path(), name, text);
        let emitted = super::files(super::target("c"), designed, block)?;
        for file in &emitted {
            write(&file.name, &file.text)?;
        }
        let stem = emitted.first().and_then(|file| file.name.strip_suffix(".h")).unwrap_or_default();
        for file in super::of_set(super::target("c"), designed, block)? {
            write(&file.name, &file.text)?;
        }
        write("layout.h", &layout(stem, block))?;
        write("harness.c", include_str!("harness.c"))?;
        let harness = ["-std=c99", "-O2", "-DLAYOUT=\"layout.h\"", "-c", "harness.c", "-o", "harness.o"];
        compiler.call(folder.path(), &harness, &[])?;
        let sources = emitted.iter().map(|file| &file.name).filter(|name| name.ends_with(".c")).cloned().collect();
        Ok(Self { folder, sources, block: block.clone() })
    }

    /// Compiles the block (only the block with the compiler's options) and runs it.
    ///
    /// # Errors
    /// The compiler rejects it, or the block fails its self-test.
    pub fn run(&self, inputs: &Samples, compiler: &Compiler) -> Result<Samples, Failure> {
        let build = process::folder()?;
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
        process::run(&program, &[], &self.block, inputs)
    }
}

/// The description of the block for the harness.
fn layout(stem: &str, block: &Block) -> String {
    let program = &block.for_axis.program;
    let real = program.real;
    let [mut inputs, outputs] = signals(program, &LANGUAGE);
    // The parameter set is a struct of the harness, to which the inputs point.
    for (name, input) in inputs.iter_mut().zip(&program.inputs) {
        if program.in_set(input).is_none() {
            name.insert_str(0, "inputs.");
        }
    }
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
    format!(
        "#include \"{stem}.h\"\n#define BLOCK(name) {stem}_##name\n#define IN_FRAME {}\n#define OUT_FRAME {}\n\
         #define GET_INPUTS{}\n#define PUT_OUTPUTS{}\n{}",
        process::frame(&program.inputs, real),
        process::frame(&program.outputs, real),
        access("GET", &program.inputs, &inputs),
        access("PUT", &program.outputs, &outputs),
        if program.has_set() { "#define HAS_SET\n" } else { "" },
    )
}
