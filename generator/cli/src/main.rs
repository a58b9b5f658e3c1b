//! The command `axgen`: dispatches to the files of the commands. No work is done here.
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler
#![forbid(unsafe_code)]
#![warn(clippy::print_stderr)] // `output` prints

mod analyze;
mod arguments;
mod check;
mod command_line;
mod compare_files;
mod compared;
mod compiler;
mod diff;
mod emit;
mod exit;
mod explain;
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
mod params;
mod params_of;
mod plan;
mod recorded;
mod results;
mod run;
mod scenario;
mod schema;
mod shared;
mod shell;
mod simulate;
mod times;
mod tune;
mod verify;

use arguments::{Cli, Command, Golden, OneFile, ToFile};
use compare_files::Show;
use exit::Exit;
use generator::config::ListOptions;
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
        Command::Generate { set, targets, axes, runner, out, force, check, diff, emit } => {
            let compare = if diff { Some(Show::Lines) } else { check.then_some(Show::Names) };
            generate::run(
                &set,
                format,
                &generate::GenerateArguments { targets, axes, runner, out, force, compare, emit },
            )
        }
        Command::Check { set, verbose } => check::run(&set, format, verbose),
        Command::Run {
            set,
            axis,
            block,
            engine,
            stimulus,
            scenario,
            program_axis,
            cycles,
            compare,
            map,
            out,
            force,
            hex,
        } => {
            let options = scenario::options(program_axis, cycles);
            let of =
                run::RunArguments { axis, block, engine, stimulus, scenario, options, compare, map, out, force, hex };
            run::run(&set, format, &of)
        }
        Command::Verify { set, samples, scenario: None, engines, results, .. } => {
            verify::run(&set, format, samples, &engines, &results)
        }
        Command::Verify {
            set, scenario: Some(program), axis, block, program_axis, cycles, engines, results, ..
        } => {
            let options = scenario::options(program_axis, cycles);
            let request = verify::Scenario { program, axis, block, options };
            verify::run_scenario(&set, format, &request, &engines, &results)
        }
        Command::Analyze { set, axis, drive, to } => analyze::run(&set, format, axis.as_deref(), &drive, &to),
        Command::Simulate { set, axis, drive, to } => simulate::run(&set, format, axis.as_deref(), &drive, &to),
        Command::Measure { recording, of } => measure::run(&recording, &of, format),
        Command::Tune { set, axis, of } => tune::run(&set, format, axis.as_deref(), &of),
        Command::Scenario { set, program, axis, block, drive, program_axis, cycles, stimulus, picture, force } => {
            let options = scenario::options(program_axis, cycles);
            let request =
                scenario::ScenarioArguments { axis, block, drive, program, options, stimulus, picture, force };
            scenario::run(&set, format, &request)
        }
        Command::Diff { old, new, cycle_time, name } => {
            diff::run(&old, &new, &ListOptions { cycle_time, name, ..ListOptions::default() }, format)
        }
        Command::Import { list, cycle_time, name, to: OneFile { out, force } } => {
            import::run(&list, import::ImportArguments { cycle_time, name, out: out.as_deref(), force, format })
        }
        Command::Export { set, axis, to } => export::run(&set, axis.as_deref(), to.out.as_deref(), to.force, format),
        Command::Params { parameter, markdown } => params::run(parameter.as_deref(), markdown),
        Command::ParamsOf { set, axis, on, form, to: ToFile { output, force } } => {
            params_of::run(&set, format, &params_of::ParamsOfArguments { axis, on, form, out: output, force })
        }
        Command::Explain { code } => explain::run(code.as_deref()),
        Command::Init { file } => init::run(&file),
        Command::Schema => schema::run(),
        Command::Completions { shell } => shell::completions(shell),
        Command::Man { folder, force } => shell::man(&folder, force),
        Command::Golden { command: Golden::Record { cases, again } } => golden_cases::record(&cases, again),
        Command::Golden { command: Golden::Verify { cases, results } } => golden_cases::verify(&cases, &results),
    }
}
