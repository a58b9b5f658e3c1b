//! Whether the compiler of an engine works at all: distinguishes a compiler that cannot compile anything from one that
//! refuses a block.

use golden::engine::{Compiler, Engine, rust};
use std::path::Path;
use std::process::Command;

/// The compiler that an engine needs.
struct Needed {
    language: &'static str,
    command: String,
    /// the environment variable that selects another one
    variable: &'static str,
    options: &'static [&'static str],
    /// a program that every such compiler accepts, with its file name
    program: [&'static str; 2],
}

fn needed(engine: Engine) -> Option<Needed> {
    match engine {
        Engine::C => Some(Needed {
            language: "C",
            command: Compiler::host().command,
            variable: "CC",
            options: &["-std=c99"],
            program: ["works.c", "int main(void) { return 0; }\n"],
        }),
        Engine::Rust => Some(Needed {
            language: "Rust",
            command: rust::command(),
            variable: "RUSTC",
            options: &[],
            program: ["works.rs", "fn main() {}\n"],
        }),
        Engine::Reference | Engine::Program | Engine::St | Engine::TwinCat | Engine::Codesys | Engine::Scl => None,
    }
}

/// Whether an engine's compiler, if it needs one, produces a program that runs.
fn works(engine: Engine) -> bool {
    let Some(Needed { command, options, program: [name, text], .. }) = needed(engine) else { return true };
    let Ok(folder) = tempfile::tempdir() else { return false };
    let (source, program) = (folder.path().join(name), folder.path().join("works"));
    if std::fs::write(&source, text).is_err() {
        return false;
    }
    let compiler = Command::new(command).arg("-o").arg(&program).args(options).arg(&source).output();
    compiler.is_ok_and(|output| output.status.success()) && runs(&program)
}

fn runs(program: &Path) -> bool {
    Command::new(program).output().is_ok_and(|output| output.status.success())
}

/// The message about an engine that does not work at all; `text` is the engine's own message.
pub fn broken(engine: Engine, text: &str) -> Option<String> {
    let Needed { language, command, variable, .. } = needed(engine).filter(|_| !works(engine))?;
    let text = if text.trim().is_empty() { "nothing" } else { text.trim() };
    Some(format!(
        "the {language} compiler `{command}` cannot compile an empty program; mend it, or set {variable} to another. \
         It said: {text}"
    ))
}
