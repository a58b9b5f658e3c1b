//! The command line: what it takes, in the words of its help. Nothing is done here.

use crate::emit;
use crate::messages::Format;
use crate::results::Files;
use crate::verify;
use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;
use std::path::PathBuf;

/// Vibration damping for PLCs and drives: from axis parameters to blocks that are proven bit by bit.
#[derive(Parser)]
#[command(name = "axgen", version, max_term_width = 100)]
pub struct Cli {
    /// What messages look like
    #[arg(long, global = true, value_name = "FORMAT", default_value = "human")]
    pub message_format: Format,
    /// what is to be done
    #[command(subcommand)]
    pub command: Command,
}

/// What can be done.
#[derive(Subcommand)]
pub enum Command {
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
        /// Write nothing; name the files on disk that differ from what would be written, and end with 1 if any does
        #[arg(long, conflicts_with_all = ["diff", "emit", "force"])]
        check: bool,
        /// The same, with the lines that differ
        #[arg(long, conflicts_with_all = ["emit", "force"])]
        diff: bool,
        #[arg(long, value_name = "STAGE", conflicts_with = "force", help = emit::help())]
        emit: Option<String>,
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
        /// reference, program, c, st, twincat, codesys or scl
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
        #[arg(long, value_name = "N", default_value = "100000", value_parser = verify::samples)]
        samples: usize,
        #[command(flatten)]
        results: Files,
    },
    /// Says what a change between two sets means: in Hz, dB, degrees, seconds
    Diff {
        /// The set (or list) before
        old: PathBuf,
        /// The set (or list) after
        new: PathBuf,
        /// Position-controller cycle of axis lists
        #[arg(long, value_name = "TIME")]
        cycle_time: Option<String>,
        /// Name of an axis list's axis [default: from the file's name]
        #[arg(long, value_name = "NAME")]
        name: Option<String>,
    },
    /// Turns an axis list into a TOML set; nothing of the list is lost
    Import {
        /// The axis list
        list: PathBuf,
        /// Position-controller cycle, which no list holds: 1ms, 62.5us
        #[arg(long, value_name = "TIME")]
        cycle_time: Option<String>,
        /// Name of the axis [default: from the file's name]
        #[arg(long, value_name = "NAME")]
        name: Option<String>,
        #[command(flatten)]
        to: OneFile,
    },
    /// Turns an axis of a set into an axis list
    Export {
        /// The set
        set: PathBuf,
        /// The axis; may be left out where the set has one
        #[arg(long, value_name = "X")]
        axis: Option<String>,
        #[command(flatten)]
        to: OneFile,
    },
    /// What a parameter is: its meaning, range, unit, default
    Params {
        /// Its id (P-AXIS-00751, or 00751), its path, or the end of its path; none: all parameters
        #[arg(value_name = "ID or PATH")]
        parameter: Option<String>,
        /// The reference page of all parameters
        #[arg(long, conflicts_with = "parameter")]
        markdown: bool,
    },
    /// What the code of a message means, and what to do
    Explain {
        /// The code (AX304); none: all codes
        code: Option<String>,
    },
    /// Writes a commented set to start from
    Init {
        /// The file, which must not be there yet
        #[arg(default_value = "axes.toml")]
        file: PathBuf,
    },
    /// Prints the JSON schema of a set, for editors
    Schema,
    /// Prints the completions of a shell
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Writes the manual's pages
    Man {
        /// The folder for them
        #[arg(default_value = "man")]
        folder: PathBuf,
        /// Overwrite files that axgen did not make, or that were changed by hand
        #[arg(long)]
        force: bool,
    },
    /// Vectors to keep in a repository
    Golden {
        #[command(subcommand)]
        command: Golden,
    },
}

/// What can be done with golden cases.
#[derive(Subcommand)]
pub enum Golden {
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
        #[command(flatten)]
        results: Files,
    },
}

/// The input of most commands.
#[derive(Args)]
pub struct SetArguments {
    /// A TOML axis set (.toml), or one axis list (any other file)
    pub set: PathBuf,
    /// Position-controller cycle of an axis list: 1ms, 62.5us
    #[arg(long, value_name = "TIME")]
    pub cycle_time: Option<String>,
    /// Name of an axis list's axis [default: from the file's name]
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
}

/// Where a single file goes.
#[derive(Args)]
pub struct OneFile {
    /// The file to write, `-`: standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replace a file that is there
    #[arg(long)]
    pub force: bool,
}
