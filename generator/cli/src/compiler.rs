//! Whether the C compiler of the host works at all: to tell a program that cannot compile anything from one that refuses a block.

use golden::engine::Compiler;
use std::path::Path;
use std::process::Command;

/// A program that every C compiler takes.
const PROGRAM: &str = "int main(void) { return 0; }\n";

/// Whether the compiler makes a program that runs.
pub fn works() -> bool {
    let Ok(folder) = tempfile::tempdir() else { return false };
    let (source, program) = (folder.path().join("works.c"), folder.path().join("works"));
    if std::fs::write(&source, PROGRAM).is_err() {
        return false;
    }
    let compiler = Command::new(Compiler::host().command).args(["-std=c99", "-o"]).args([&program, &source]).output();
    compiler.is_ok_and(|output| output.status.success()) && runs(&program)
}

fn runs(program: &Path) -> bool {
    Command::new(program).output().is_ok_and(|output| output.status.success())
}

/// What is said of one that does not; `text` is what it said itself.
pub fn broken(text: &str) -> String {
    let Compiler { command, .. } = Compiler::host();
    let text = if text.trim().is_empty() { "nothing" } else { text.trim() };
    format!(
        "the C compiler `{command}` cannot compile an empty program; mend it, or set CC to another. It said: {text}"
    )
}
