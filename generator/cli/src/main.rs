//! The command `axgen`: which file does what was asked for. No work is done here.
#![forbid(unsafe_code)]

mod arguments;
mod check;
mod compare_files;
mod diff;
mod emit;
mod exit;
mod explain;
mod export;
mod generate;
mod golden_cases;
mod import;
mod init;
mod input;
mod messages;
mod one_file;
mod params;
mod results;
mod run;
mod schema;
mod shell;
mod summary;
mod verify;

use arguments::{Cli, Command, Golden, OneFile};
use clap::Parser;
use compare_files::Show;
use exit::Exit;
use generator::config::ListOptions;
use std::process::ExitCode;

fn main() -> ExitCode {
    sigpipe::reset();
    let result = match Cli::parse().command {
        Command::Generate { set, targets, axes, out, force, check, diff, emit } => {
            let compare = if diff { Some(Show::Lines) } else { check.then_some(Show::Names) };
            generate::run(&set, &generate::Request { targets, axes, out, force, compare, emit })
        }
        Command::Check { set } => check::run(&set),
        Command::Run { set, axis, block, engine, stimulus, compare, out, hex } => {
            run::run(&set, &run::Request { axis, block, engine, stimulus, compare, out, hex })
        }
        Command::Verify { set, samples, results } => verify::run(&set, samples, &results),
        Command::Diff { old, new, cycle_time, name } => diff::run(&old, &new, &ListOptions { cycle_time, name }),
        Command::Import { list, cycle_time, name, to } => {
            let OneFile { out, force, message_format } = to;
            let request = import::Request { cycle_time, name, out: out.as_deref(), force, message_format };
            import::run(&list, request)
        }
        Command::Export { set, axis, to } => {
            export::run(&set, axis.as_deref(), to.out.as_deref(), to.force, to.message_format)
        }
        Command::Params { parameter, markdown } => params::run(parameter.as_deref(), markdown),
        Command::Explain { code } => explain::run(code.as_deref()),
        Command::Init { file } => init::run(&file),
        Command::Schema => schema::run(),
        Command::Completions { shell } => shell::completions(shell),
        Command::Man { folder } => shell::man(&folder),
        Command::Golden { command: Golden::Record { cases } } => golden_cases::record(&cases),
        Command::Golden { command: Golden::Verify { cases, results } } => golden_cases::verify(&cases, &results),
    };
    result.unwrap_or_else(|exit: Exit| exit.say()).into()
}
