//! Compilers: their calls, and the meaning of their failures.

use super::Failure;
use std::path::Path;
use std::process::Command;

/// A C compiler with its options.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compiler {
    pub command: String,
    /// its options for the emitted file
    pub options: Vec<String>,
    /// its options for linking
    pub link: Vec<String>,
}

impl Compiler {
    /// The host's compiler as usually called: `$CC` or `cc`, `-std=c99 -O2`.
    #[must_use]
    pub fn host() -> Self {
        let command = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
        Self::new(&command, &["-O2"])
    }

    /// A compiler by name, with `-std=c99` and further options.
    #[must_use]
    pub fn new(command: &str, options: &[&str]) -> Self {
        let options = [&["-std=c99"], options].concat();
        Self { command: command.to_owned(), options: owned(&options), link: Vec::new() }
    }

    /// This compiler with options for linking.
    #[must_use]
    pub fn linking(self, options: &[&str]) -> Self {
        Self { link: owned(options), ..self }
    }

    /// Calls the compiler in a folder.
    pub(super) fn call(&self, folder: &Path, arguments: &[&str], options: &[String]) -> Result<(), Failure> {
        let arguments: Vec<&str> = arguments.iter().copied().chain(options.iter().map(String::as_str)).collect();
        call("C", "CC", &self.command, folder, &arguments)
    }
}

/// Calls the compiler of a language in a folder; an environment variable selects it.
pub(super) fn call(
    language: &str,
    variable: &str,
    command: &str,
    folder: &Path,
    arguments: &[&str],
) -> Result<(), Failure> {
    let output = Command::new(command).current_dir(folder).args(arguments).output();
    let output = output.map_err(|error| {
        Failure::Environment(format!(
            "the {language} compiler `{command}` does not start ({error}); install it, or set {variable} to another"
        ))
    })?;
    if output.status.success() {
        return Ok(());
    }
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(if errors.contains("this block needs") { Failure::Refused(errors) } else { Failure::Broken(errors) })
}

fn owned(options: &[&str]) -> Vec<String> {
    options.iter().map(|option| (*option).to_owned()).collect()
}
