//! The command line: its arguments, in the words of its help. Nothing is done here.

use crate::measure;
use crate::messages::Format;
use crate::results::Files;
use crate::run;
use crate::scenario;
use crate::simulate;
use crate::verify;
use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;
use commands::emit;
use golden::measure::Excitation;
use std::path::PathBuf;

/// Vibration damping for PLCs and drives: generates function blocks from axis parameters and verifies them bit by bit.
#[derive(Parser)]
#[command(name = "axgen", version, max_term_width = 100)]
pub struct Cli {
    /// Format of the messages
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
    Generate(GenerateArguments),
    /// Reads and checks only; says in words what the blocks mean for the machine
    Check {
        #[command(flatten)]
        set: SetArguments,
        /// Show the certified range and the measured response, too
        #[arg(long)]
        verbose: bool,
    },
    /// Runs one block through one engine, sample by sample
    Run(RunArguments),
    /// Runs every block of every axis through every engine and counts the bits that differ from the reference
    Verify(VerifyArguments),
    /// Says whether the loop of an axis is stable, how far from instability it is, and which weights it bears
    Analyze(AnalyzeArguments),
    /// Runs the block of an axis in a closed loop with a drive, off against on: vibrations, following error, stability
    Simulate(SimulateArguments),
    /// Measures a recording of an axis: sampling, vibrations, and with an excitation the response of the drive
    Measure(MeasureArguments),
    /// Proposes stages for an axis from its recordings, with what they would leave of each vibration
    Tune(TuneArguments),
    /// Writes all of the axes as one page of HTML, to print and to archive: parameters, loops, coefficients, verification
    Report(ReportArguments),
    /// Runs an NC program on an axis, in a closed loop with a simple drive: a stimulus for `run`, and a picture
    Scenario(ScenarioArguments),
    /// Shows what a change between two sets means, in Hz, dB, degrees, seconds and margins
    Diff {
        /// The set (or list) before
        old: PathBuf,
        /// The set (or list) after
        new: PathBuf,
        #[command(flatten)]
        read: ListArguments,
    },
    /// Converts an axis list into a TOML set, without loss
    Import {
        /// The axis list
        list: PathBuf,
        #[command(flatten)]
        read: ListArguments,
        #[command(flatten)]
        to: OneFile,
    },
    /// Converts an axis of a set into an axis list
    Export {
        /// The set
        set: PathBuf,
        /// The axis; optional if the set has only one
        #[arg(long, value_name = "X")]
        axis: Option<String>,
        #[command(flatten)]
        to: OneFile,
    },
    /// Explains a parameter: its meaning, range, unit and default
    Params {
        /// Id (P-AXIS-00751, or 00751), path, or end of the path [default: all parameters]
        #[arg(value_name = "ID or PATH")]
        parameter: Option<String>,
        /// Print the reference page of all parameters as Markdown
        #[arg(long, conflicts_with = "parameter")]
        markdown: bool,
    },
    /// Writes the parameter set of an axis with `tunable = "all"` or `"parameters"`, for the block generated from OLD
    ParamsOf(ParamsOfArguments),
    /// Explains the code of a message, an error of the controller, an error_id of a block, a signal or a word, and what to do
    Explain {
        /// The code (AX304), the error (70350, P-ERR-70350), the error_id (12), a signal (limited), a parameter or a word of one
        /// (DRYRUN) [default: all codes]
        code: Option<String>,
    },
    /// Writes a commented set to start from
    Init {
        /// The file; it must not exist yet
        #[arg(default_value = "axes.toml")]
        file: PathBuf,
    },
    /// Prints the JSON schema of a set, for editors
    Schema,
    /// Prints the command-line completions for a shell
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Writes the manual pages
    Man {
        /// The folder for them
        #[arg(default_value = "man")]
        folder: PathBuf,
        /// Overwrite files that axgen did not write, or that were changed by hand
        #[arg(long)]
        force: bool,
    },
    /// Records and verifies golden cases: test vectors to keep in a repository
    Golden {
        #[command(subcommand)]
        command: Golden,
    },
}

/// What can be done with golden cases.
#[derive(Subcommand)]
pub enum Golden {
    /// Writes the current outputs of the reference as the vectors of these cases
    Record {
        /// Folders with a case.toml
        #[arg(required = true)]
        cases: Vec<PathBuf>,
        /// Record the inputs of scenarios again, too; without it they stay as they are
        #[arg(long)]
        again: bool,
    },
    /// Compares the vectors of these cases with the current outputs of the reference
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
    #[command(flatten)]
    pub list: ListArguments,
}

/// What an axis list does not contain.
#[derive(Args)]
pub struct ListArguments {
    /// Cycle time of the position controller, for an axis list: a number with its unit, s, ms, us or ns, such as 1ms or 62.5us
    #[arg(long, value_name = "TIME")]
    pub cycle_time: Option<String>,
    /// Name of an axis list's axis [default: from the file's name]
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
}

/// One axis of a set.
#[derive(Args)]
pub struct AxisArguments {
    #[command(flatten)]
    pub set: SetArguments,
    /// The axis; optional if the set has only one
    #[arg(long, value_name = "X")]
    pub axis: Option<String>,
}

/// How an NC program moves the axis.
#[derive(Args)]
pub struct ProgramArguments {
    /// The axis of the program that the axis follows [default: that of its name]
    #[arg(long, value_name = "A", requires = "scenario")]
    pub program_axis: Option<String>,
    /// Stops the scenario after this number of cycles [default: 200000]
    #[arg(long, value_name = "N", requires = "scenario", value_parser = scenario::cycles)]
    pub cycles: Option<usize>,
}

/// What is generated, and where it goes.
#[derive(Args)]
pub struct GenerateArguments {
    #[command(flatten)]
    pub set: SetArguments,
    /// Target language, may be given several times [default: the set's targets, else c and st]
    #[arg(long = "target", value_name = "T")]
    pub targets: Vec<String>,
    /// Only this axis, may be given several times
    #[arg(long = "axis", value_name = "X")]
    pub axes: Vec<String>,
    /// Write a runner next to each block in C: a program for your own board that compares this number of samples with the reference [default: 100000]
    #[arg(long, value_name = "SAMPLES", num_args = 0..=1, require_equals = true, default_missing_value = "100000",
        value_parser = verify::samples, conflicts_with = "emit")]
    pub runner: Option<usize>,
    /// Write a description of each block in C for calibration tools (A2L): names, units and limits of its signals
    #[arg(long, conflicts_with = "emit")]
    pub a2l: bool,
    /// Folder for the files; created if it does not exist
    #[arg(long, value_name = "DIR", default_value = "generated")]
    pub out: PathBuf,
    /// Overwrite files that were changed by hand
    #[arg(long)]
    pub force: bool,
    /// Write nothing; list the files that differ or are no longer generated; exit code 1 if there are any
    #[arg(long, conflicts_with_all = ["diff", "emit", "force"])]
    pub check: bool,
    /// As --check, and show the lines that differ
    #[arg(long, conflicts_with_all = ["emit", "force"])]
    pub diff: bool,
    #[arg(long, value_name = "STAGE", conflicts_with = "force", help = emit::help())]
    pub emit: Option<String>,
}

/// The block and the engine of a run, its samples, and where its outputs go.
#[derive(Args)]
pub struct RunArguments {
    #[command(flatten)]
    pub subject: AxisArguments,
    /// The block: ipc, feedforward, position_control, spindle, axis, spindle_axis, excitation or set_design
    #[arg(long, value_name = "B", default_value = "ipc")]
    pub block: String,
    /// The engine: reference, program, c, rust, st, twincat, codesys or scl
    #[arg(long, value_name = "E", default_value = "reference")]
    pub engine: String,
    /// CSV file with the inputs, `-`: standard input
    #[arg(long, value_name = "FILE", required_unless_present_any = ["compare", "scenario"])]
    pub stimulus: Option<PathBuf>,
    /// NC program whose scenario gives the inputs
    #[arg(long, value_name = "FILE", conflicts_with = "stimulus")]
    pub scenario: Option<PathBuf>,
    #[command(flatten)]
    pub moved_by: ProgramArguments,
    /// CSV file with recorded outputs, and inputs unless --stimulus gives them; counts the bits that differ
    #[arg(long, value_name = "FILE")]
    pub compare: Option<PathBuf>,
    /// Which column of the CSV file is which signal, where the names differ; `SCOPE=-` leaves a column out
    #[arg(long, value_name = "SCOPE=SIGNAL", value_parser = run::mapping)]
    pub map: Vec<(String, String)>,
    /// CSV file for the outputs, `-`: standard output [default: -, with --compare none]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replace any file of that name, not only an earlier output of this command
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Writes reals as the hexadecimal digits of their bits
    #[arg(long)]
    pub hex: bool,
}

/// The runs of a verification.
#[derive(Args)]
pub struct VerifyArguments {
    #[command(flatten)]
    pub set: SetArguments,
    /// Samples of each run
    #[arg(long, value_name = "N", default_value = "100000", value_parser = verify::samples)]
    pub samples: usize,
    /// NC program whose scenario gives the inputs of one block
    #[arg(long, value_name = "FILE", conflicts_with = "samples")]
    pub scenario: Option<PathBuf>,
    /// The axis of the scenario; optional if the set has only one
    #[arg(long, value_name = "X", requires = "scenario")]
    pub axis: Option<String>,
    /// The block of the scenario [default: spindle, else axis, else the one that there is]
    #[arg(long, value_name = "B", requires = "scenario")]
    pub block: Option<String>,
    #[command(flatten)]
    pub moved_by: ProgramArguments,
    /// Only this engine in addition to the reference, may be given several times [default: all]
    #[arg(long = "engine", value_name = "E")]
    pub engines: Vec<String>,
    #[command(flatten)]
    pub results: Files,
}

/// What stands for the drive: each option means the same as the key of an axis `drive.*`, and takes its place.
#[derive(Args, Default)]
pub struct DriveArguments {
    /// Cycles after which the motor does what was commanded [default: 1.5]
    #[arg(long, value_name = "CYCLES")]
    pub delay: Option<String>,
    /// Time constant after that: 3ms
    #[arg(long, value_name = "TIME")]
    pub time_constant: Option<String>,
    /// CSV file with a measured frequency response to the velocity of the motor, instead of the time constant; --delay is
    /// then the delay that the measurement lacks [default: 0]
    #[arg(long, value_name = "FILE")]
    pub response: Option<String>,
    /// What the response is from: v_cmd or current [default: v_cmd]
    #[arg(long, value_name = "SIGNAL")]
    pub response_from: Option<String>,
    /// Gain of the speed controller, for a response from the current
    #[arg(long, value_name = "KP")]
    pub speed_gain: Option<String>,
    /// Integral time of the speed controller, for a response from the current
    #[arg(long, value_name = "TIME")]
    pub speed_integral_time: Option<String>,
}

/// What is analysed, and where the analysis goes.
#[derive(Args)]
pub struct AnalyzeArguments {
    #[command(flatten)]
    pub set: SetArguments,
    /// Only this axis [default: all]
    #[arg(long, value_name = "X")]
    pub axis: Option<String>,
    #[command(flatten)]
    pub drive: DriveArguments,
    /// Print it for machines: JSON
    #[arg(long)]
    pub json: bool,
    /// SVG file for the picture of one axis: Bode diagrams, |S|, Nyquist curve
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// Replace any file of that name, not only an earlier picture
    #[arg(long)]
    pub force: bool,
}

/// What is simulated, and where it goes.
#[derive(Args)]
pub struct SimulateArguments {
    #[command(flatten)]
    pub subject: AxisArguments,
    #[command(flatten)]
    pub drive: DriveArguments,
    /// A machine with mechanics instead of the drive
    #[arg(long, value_name = "PLANT", value_parser = ["demonstration"],
        conflicts_with_all = ["delay", "time_constant", "response", "response_from", "speed_gain", "speed_integral_time"])]
    pub plant: Option<String>,
    /// Time at constant speed, each way: 2s [default: 1.5s, longer where the ripple needs it]
    #[arg(long, value_name = "TIME", value_parser = simulate::dwell)]
    pub dwell: Option<f64>,
    /// CSV file for both runs, a line each cycle
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// SVG file for the picture
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// CSV file for the moves with every stage off, as a recorder on the controller would save them, for `measure` and `tune`
    #[arg(long, value_name = "FILE")]
    pub moves: Option<PathBuf>,
    /// CSV file for a move with the block `excitation`, as a recorder would save it
    #[arg(long, value_name = "FILE")]
    pub excited: Option<PathBuf>,
    /// CSV file for all inputs and outputs of the block in mode ON, as a recorder would save them, for `run --compare`
    #[arg(long, value_name = "FILE")]
    pub recorded: Option<PathBuf>,
    /// Speed of the move with the excitation: 20mm/s [default: 4 amplitudes]
    #[arg(long, value_name = "SPEED", value_parser = simulate::speed, requires = "excited")]
    pub speed: Option<f64>,
    /// Noise of the recorded velocity and acceleration, rms, as a part of their peak: 0.1% [default: none]
    #[arg(long, value_name = "PART", value_parser = simulate::noise)]
    pub noise: Option<f64>,
    /// Replace any files of these names, not only earlier outputs of this command; a file of --recorded needs it always
    #[arg(long)]
    pub force: bool,
}

/// What is measured, and how, and where the results go.
#[derive(Args)]
pub struct MeasureArguments {
    /// CSV file of a recorder, `-`: standard input
    pub recording: PathBuf,
    /// A second recording of the same machine, made with an excitation: the response, and the side that vibrations are from
    #[arg(long, value_name = "FILE")]
    pub excited: Option<PathBuf>,
    /// The excited recording's sequence: bits of the register, and cycles of a clock, such as 11x2; `default`: that of the cycle
    /// [default: as v_excite shows it]
    #[arg(long, value_name = "BITS[xCLOCK]", value_parser = measure::excitation)]
    pub excitation: Option<Excitation>,
    /// Interval of the rows, for a recording without times: a number with its unit, s, ms, us or ns, such as 1ms or 62.5us
    #[arg(long, value_name = "TIME", value_parser = measure::interval)]
    pub cycle_time: Option<f64>,
    /// Which column of the CSV file is which signal, where the names differ; `SCOPE=-` leaves a column out
    #[arg(long, value_name = "SCOPE=SIGNAL", value_parser = run::mapping)]
    pub map: Vec<(String, String)>,
    /// CSV file for the response, which `drive.response` reads
    #[arg(long, value_name = "FILE")]
    pub response: Option<PathBuf>,
    /// SVG file for the picture
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// Print it for machines: JSON
    #[arg(long)]
    pub json: bool,
    /// Replace any files of these names, not only earlier outputs of this command
    #[arg(long)]
    pub force: bool,
}

/// What stages are proposed from.
#[derive(Args)]
pub struct TuneArguments {
    #[command(flatten)]
    pub subject: AxisArguments,
    /// CSV file of a recorder: moves with all stages off, from rest to rest
    #[arg(long, value_name = "FILE")]
    pub recording: PathBuf,
    /// A second recording of the same machine, made with an excitation: the response, and the side that vibrations are from
    #[arg(long, value_name = "FILE")]
    pub excited: Option<PathBuf>,
    /// The excited recording's sequence: bits of the register, and cycles of a clock, such as 11x2; `default`: that of the cycle
    /// [default: as v_excite shows it]
    #[arg(long, value_name = "BITS[xCLOCK]", value_parser = measure::excitation, requires = "excited")]
    pub excitation: Option<Excitation>,
    /// CSV file with a measured response of the drive, instead of that of the set and of the excited recording
    #[arg(long, value_name = "FILE")]
    pub response: Option<String>,
    /// Which column of the CSV files is which signal, where the names differ; `SCOPE=-` leaves a column out
    #[arg(long, value_name = "SCOPE=SIGNAL", value_parser = run::mapping)]
    pub map: Vec<(String, String)>,
    /// A stage of one's own instead of proposals, up to three times: keys of a stage as a set has them, such as
    /// mode=DIRECT,fg_f0=53,q_factor=10,weight=0.5,allpass=24.5/2; `set`: the stages of the set
    #[arg(long, value_name = "KEY=VALUE,...")]
    pub stage: Vec<String>,
    /// Write a proposal into the set, or into the axis list that is given as the set: its stages instead of those of the axis, and
    /// enable DRYRUN
    #[arg(long, value_name = "PROPOSAL", value_parser = ["recommended", "strong", "cautious", "first"], conflicts_with = "stage")]
    pub apply: Option<String>,
    /// CSV file for the recorded moves as they would have been with the stages: those of --stage, of --apply, else the first proposal
    #[arg(long, value_name = "FILE")]
    pub signals: Option<PathBuf>,
    /// SVG file for a picture of the same
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// Print it for machines: JSON
    #[arg(long)]
    pub json: bool,
    /// Replace any files of these names, not only earlier pictures
    #[arg(long)]
    pub force: bool,
}

/// What is reported, and where the page goes.
#[derive(Args)]
pub struct ReportArguments {
    #[command(flatten)]
    pub set: SetArguments,
    /// Only this axis, may be given several times [default: all]
    #[arg(long = "axis", value_name = "X")]
    pub axes: Vec<String>,
    #[command(flatten)]
    pub drive: DriveArguments,
    /// Target whose files are traced, may be given several times [default: the set's targets, else c and st]
    #[arg(long = "target", value_name = "T")]
    pub targets: Vec<String>,
    /// Engine in addition to the reference, may be given several times [default: all that need no compiler]
    #[arg(long = "engine", value_name = "E")]
    pub engines: Vec<String>,
    /// Samples of each run
    #[arg(long, value_name = "N", default_value = "20000", value_parser = verify::samples)]
    pub samples: usize,
    /// CSV file of a recorder, of one axis: moves with all stages off, from rest to rest
    #[arg(long, value_name = "FILE")]
    pub recording: Option<PathBuf>,
    /// A second recording of the same machine, made with an excitation: the response, and the side that vibrations are from
    #[arg(long, value_name = "FILE", requires = "recording")]
    pub excited: Option<PathBuf>,
    /// The excited recording's sequence: bits of the register, and cycles of a clock, such as 11x2; `default`: that of the cycle
    /// [default: as v_excite shows it]
    #[arg(long, value_name = "BITS[xCLOCK]", value_parser = measure::excitation, requires = "excited")]
    pub excitation: Option<Excitation>,
    /// Which column of the CSV files is which signal, where the names differ; `SCOPE=-` leaves a column out
    #[arg(long, value_name = "SCOPE=SIGNAL", value_parser = run::mapping, requires = "recording")]
    pub map: Vec<(String, String)>,
    /// HTML file for the page, `-`: standard output [default: -]
    #[arg(short, long, visible_alias = "output", value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replace any file of that name, not only an earlier report
    #[arg(long, requires = "out")]
    pub force: bool,
}

/// What a program moves, and where the results go.
#[derive(Args)]
pub struct ScenarioArguments {
    #[command(flatten)]
    pub subject: AxisArguments,
    /// The NC program
    #[arg(value_name = "PROGRAM")]
    pub scenario: PathBuf,
    /// The block [default: spindle, else axis, else the one that there is]
    #[arg(long, value_name = "B")]
    pub block: Option<String>,
    #[command(flatten)]
    pub drive: DriveArguments,
    #[command(flatten)]
    pub moved_by: ProgramArguments,
    /// CSV file for the inputs of the block
    #[arg(long, value_name = "FILE")]
    pub stimulus: Option<PathBuf>,
    /// SVG file for the picture
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    /// Replace any files of these names, not only earlier outputs of this command
    #[arg(long)]
    pub force: bool,
}

/// The parameter set that is written, and where it goes.
#[derive(Args)]
pub struct ParamsOfArguments {
    #[command(flatten)]
    pub subject: AxisArguments,
    /// The set that the block on the machine was generated from
    #[arg(long, value_name = "OLD")]
    pub on: PathBuf,
    /// The form: c, rust, st, scl, csv or bin
    #[arg(long = "as", value_name = "FORM", default_value = "c")]
    pub form: String,
    #[command(flatten)]
    pub to: OneFile,
}

/// Where a single file goes.
#[derive(Args)]
pub struct OneFile {
    /// The file to write, `-`: standard output
    #[arg(short, long, visible_alias = "output", value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replace the file if it exists
    #[arg(long)]
    pub force: bool,
}
