//! The command `axgen`: what it takes, and which file does it. No work is done here.
#![forbid(unsafe_code)]

mod check;
mod exit;
mod generate;
mod golden_cases;
mod input;
mod run;
mod summary;
mod verify;

use clap::{Args, Parser, Subcommand};
use exit::Exit;
use std::path::PathBuf;
use std::process::ExitCode;

/// Vibration damping for PLCs and drives: from axis parameters to blocks that are proven bit by bit.
#[derive(Parser)]
#[command(name = "axgen", version, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Writes the blocks of every axis
    Generate {
        #[command(flatten)]
        set: SetArguments,
        /// Target language, may be given several times [default: the set's targets, else c and st]
        #[arg(long = "target", value_name = "T")]
        targets: Vec<String>,
        /// Only this axis, may be given several times
        #[arg(long = "axis", value_name = "X")]
        axes: Vec<String>,
        /// Folder for the files, made if need be
        #[arg(long, value_name = "DIR", default_value = "generated")]
        out: PathBuf,
        /// Overwrite files that were changed by hand
        #[arg(long)]
        force: bool,
    },
    /// Reads and checks only
    Check {
        #[command(flatten)]
        set: SetArguments,
    },
    /// Runs one block through one engine, sample by sample
    Run {
        #[command(flatten)]
        set: SetArguments,
        /// The axis; may be left out where the set has one
        #[arg(long, value_name = "X")]
        axis: Option<String>,
        /// The block
        #[arg(long, value_name = "B", default_value = "ipc")]
        block: String,
        /// reference, program, c, st, twincat or codesys
        #[arg(long, value_name = "E", default_value = "reference")]
        engine: String,
        /// CSV file with the inputs, `-`: standard input
        #[arg(long, value_name = "FILE", required_unless_present = "compare")]
        stimulus: Option<PathBuf>,
        /// CSV file with recorded outputs (and inputs, unless --stimulus has them): counts the bits that differ
        #[arg(long, value_name = "FILE")]
        compare: Option<PathBuf>,
        /// CSV file for the outputs, `-`: standard output [default: -, with --compare none]
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
        /// Writes reals as the hexadecimal digits of their bits
        #[arg(long)]
        hex: bool,
    },
    /// Runs every block of every axis through every engine and counts the bits that differ from the reference
    Verify {
        #[command(flatten)]
        set: SetArguments,
        /// Samples of each run
        #[arg(long, value_name = "N", default_value_t = 100_000)]
        samples: usize,
    },
    /// Vectors to keep in a repository
    Golden {
        #[command(subcommand)]
        command: Golden,
    },
}

#[derive(Subcommand)]
enum Golden {
    /// Writes the vectors of these cases as the reference gives them now
    Record {
        /// Folders with a case.toml
        #[arg(required = true)]
        cases: Vec<PathBuf>,
    },
    /// Compares the vectors of these cases with what the reference gives now
    Verify {
        /// Folders with a case.toml
        #[arg(required = true)]
        cases: Vec<PathBuf>,
    },
}

/// The input of most commands.
#[derive(Args)]
struct SetArguments {
    /// A TOML axis set (.toml), or one axis list (any other file)
    set: PathBuf,
    /// Position-controller cycle of an axis list: 1ms, 62.5us
    #[arg(long, value_name = "TIME")]
    cycle_time: Option<String>,
    /// Name of an axis list's axis [default: from the file's name]
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
}

fn main() -> ExitCode {
    let result = match Cli::parse().command {
        Command::Generate { set, targets, axes, out, force } => generate::run(&set, &targets, &axes, &out, force),
        Command::Check { set } => check::run(&set),
        Command::Run { set, axis, block, engine, stimulus, compare, out, hex } => {
            run::run(&set, &run::Request { axis, block, engine, stimulus, compare, out, hex })
        }
        Command::Verify { set, samples } => verify::run(&set, samples),
        Command::Golden { command: Golden::Record { cases } } => golden_cases::record(&cases),
        Command::Golden { command: Golden::Verify { cases } } => golden_cases::verify(&cases),
    };
    result.unwrap_or_else(|exit: Exit| exit.say()).into()
}
