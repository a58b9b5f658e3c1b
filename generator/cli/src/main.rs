//! The command `axgen`: dispatches to the files of the commands. No work is done here.
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]
#![warn(clippy::print_stderr)] // `output` prints

mod analyze;
mod arguments;
mod check;
mod command_line;
mod compare_files;
mod compiler;
mod diff;
mod exit;
mod export;
mod generate;
mod given;
mod golden_cases;
mod import;
mod init;
mod input;
mod into_folder;
mod leftovers;
mod measure;
mod messages;
mod one_file;
mod output;
mod params_of;
mod plan;
mod recorded;
mod report;
mod results;
mod run;
mod scenario;
mod shared;
mod shell;
mod simulate;
mod tune;
mod verify;

use arguments::{Cli, Command, Golden};
use commands::{explain, params};
use exit::Exit;
use generator::{reference_page, schema};
use messages::Format;
use std::process::ExitCode;
#[cfg(unix)]
use std::sync::Arc;

#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    sigpipe::reset();
    too_large_files_are_errors();
    let Cli { command, message_format } = match command_line::read() {
        Ok(cli) => cli,
        Err(exit) => return exit.into(),
    };
    run(command, message_format).unwrap_or_else(|exit| exit.say(message_format)).into()
}

/// A write beyond a limit of file sizes then fails with a message instead of a signal that ends the command.
fn too_large_files_are_errors() {
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

/// Runs a command.
fn run(command: Command, format: Format) -> Result<Exit, Exit> {
    match command {
        Command::Generate(of) => generate::run(&of, format),
        Command::Check { set, verbose } => check::run(&set, format, verbose),
        Command::Run(of) => run::run(&of, format),
        Command::Verify(of) => verify::run(&of, format),
        Command::Analyze(of) => analyze::run(&of, format),
        Command::Simulate(of) => simulate::run(&of, format),
        Command::Measure(of) => measure::run(&of, format),
        Command::Tune(of) => tune::run(&of, format),
        Command::Report(of) => report::run(&of, format),
        Command::Scenario(of) => scenario::run(&of, format),
        Command::Diff { old, new, read } => diff::run(&old, &new, &read.options(Vec::new()), format),
        Command::Import { list, read, to } => import::run(&list, &read.options(Vec::new()), &to, format),
        Command::Export { set, axis, to } => export::run(&set, axis.as_deref(), &to, format),
        Command::Params { markdown: true, .. } => printed(reference_page::text()),
        Command::Params { parameter, markdown: false } => printed(params::text(parameter.as_deref())?),
        Command::ParamsOf(of) => params_of::run(&of, format),
        Command::Explain { code } => printed(explain::text(code.as_deref())?),
        Command::Init { file } => init::run(&file),
        Command::Schema => printed(schema::text() + "\n"),
        Command::Completions { shell } => shell::completions(shell),
        Command::Man { folder, force } => shell::man(&folder, force),
        Command::Golden { command: Golden::Record { cases, again } } => golden_cases::record(&cases, again),
        Command::Golden { command: Golden::Verify { cases, results } } => golden_cases::verify(&cases, &results),
    }
}

/// Prints the result of a command that needs no file.
fn printed(text: impl AsRef<[u8]>) -> Result<Exit, Exit> {
    output::print(text)?;
    Ok(Exit::Done)
}
