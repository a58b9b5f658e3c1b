//! `axgen completions` and `axgen man`: what the shell and the manual know of the command line, from its one definition.

use crate::arguments::Cli;
use crate::exit::Exit;
use clap::CommandFactory;
use clap_complete::Shell;
use std::io::Write;
use std::path::Path;

/// Prints the completions of a shell.
pub fn completions(shell: Shell) -> Result<Exit, Exit> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "axgen", &mut text);
    std::io::stdout().write_all(&text).map_err(|error| Exit::environment(format!("standard output: {error}")))?;
    Ok(Exit::Done)
}

/// Writes the manual's pages into a folder.
#[expect(clippy::print_stdout, reason = "what the command has done")]
pub fn man(folder: &Path) -> Result<Exit, Exit> {
    let failed = |error: std::io::Error| Exit::environment(format!("{}: {error}", folder.display()));
    std::fs::create_dir_all(folder).map_err(failed)?;
    clap_mangen::generate_to(Cli::command(), folder).map_err(failed)?;
    println!("{}: the pages are there; man -l {0}/axgen.1", folder.display());
    Ok(Exit::Done)
}
