//! The machine that a commissioning page is followed on: the demonstration plant, the block that is loaded, the files
//! of somebody who has a PC next to it. Nothing of the page here.

use axgen_tests::subject::Subject;
use machine::closed_loop::{self, Position, Record, Signals};
use machine::measure::{amplitude, dwells, ramps};
use machine::plant::DEMONSTRATION;
use machine::sequence::Sequence;
use portable::peak;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A program, its files, the machine.
pub struct Machine {
    folder: tempfile::TempDir,
    /// the program axgen
    axgen: PathBuf,
    /// the file that is generated from, and what each command gets with it
    pub set: &'static str,
    cycle_time: Option<String>,
    block: Subject,
}

/// What a move shows.
pub struct Move {
    pub record: Record,
    pub v_add_calculated: Vec<f64>,
    pub was_limited: bool,
}

impl Machine {
    /// With the shipped examples in a folder, as a user has them; nothing is loaded but the block as it is shipped.
    pub fn new(axgen: PathBuf, set: &'static str, cycle_time: Option<String>) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
        for file in ["rack-and-pinion.lis", "rack-and-pinion.toml"] {
            fs::copy(examples.join(file), folder.path().join(file)).unwrap();
        }
        let block = Subject::of(&folder.path().join(set), cycle_time.as_deref());
        Self { folder, axgen, set, cycle_time, block }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs a command of the page as it stands there: its exit code and what it prints.
    pub fn command(&self, line: &str) -> (i32, String) {
        let words = line.split(' ').map(|word| word.replace("SET", self.set));
        let words: Vec<String> = words.collect();
        assert_eq!(words[0], "axgen", "{line}");
        let time =
            self.cycle_time.iter().filter(|_| line.contains("SET")).flat_map(|time| ["--cycle-time", time.as_str()]);
        let mut command = Command::new(&self.axgen);
        command.current_dir(self.folder.path()).args(&words[1..]);
        let output = command.args(time).output().unwrap_or_else(|error| panic!("{}: {error}", self.axgen.display()));
        let text = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        (output.status.code().unwrap(), text)
    }

    /// Runs a command that has to be done with this exit code.
    pub fn done(&self, line: &str, exit: i32) -> String {
        let (code, text) = self.command(line);
        assert_eq!(code, exit, "{line}\n{text}");
        text
    }

    /// Writes a parameter into a file: a list has a line for it, a set gets one in its last table.
    pub fn write(&self, file: &str, path: &str, value: &str) {
        let file = self.path(&file.replace("SET", self.set));
        let text = fs::read_to_string(&file).unwrap();
        let (key, line) = if self.cycle_time.is_some() {
            (format!("{path} "), format!("{path} {value}"))
        } else {
            let key = path.strip_prefix("lr_param.improved_position_control.").unwrap();
            let value = if value.parse::<f64>().is_ok() { value.to_owned() } else { format!("\"{value}\"") };
            (format!("{key} "), format!("{key} = {value}"))
        };
        let mut lines: Vec<&str> = text.lines().collect();
        match lines.iter().position(|line| line.starts_with(&key)) {
            Some(at) => lines[at] = &line,
            None => lines.push(&line),
        }
        fs::write(&file, lines.join("\n") + "\n").unwrap();
    }

    /// Copies the set and the files that it names into a new folder.
    pub fn copy(&self, to: &str) {
        fs::create_dir(self.path(to)).unwrap();
        fs::copy(self.path(self.set), self.path(to).join(self.set)).unwrap();
    }

    /// Loads the block of a file, at standstill.
    pub fn load(&mut self, file: &str) {
        self.block = Subject::of(&self.path(&file.replace("SET", self.set)), self.cycle_time.as_deref());
    }

    /// Writes an input.
    pub fn set(&mut self, input: &str, value: f64) {
        // The page has the names of Structured Text and C.
        let stage = input.strip_prefix("tuning_weight").map(|stage| format!("tuning_weight[{stage}]"));
        self.block.set(stage.as_deref().unwrap_or(input), value);
    }

    /// An output of the last cycle.
    pub fn get(&self, output: &str) -> f64 {
        self.block.get(output)
    }

    /// Stands still for a time [s]; gives v_add of each cycle.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand cycles")]
    pub fn rest(&mut self, time: f64) -> Vec<f64> {
        let cycles = libm::round(time / DEMONSTRATION.cycle) as usize;
        (0..cycles).map(|_| self.block.step(&Signals::default())).collect()
    }

    /// The move in which the axis vibrates, with so much rest before and after it [s]; after that rest it is recorded for
    /// half a second more.
    pub fn make_move(&mut self, quiet: f64) -> Move {
        let sequence = Sequence { rest_before: quiet, rest_after: quiet + 0.5, ..Sequence::DEMONSTRATION };
        let (mut v_add_calculated, mut was_limited, block) = (Vec::new(), false, &mut self.block);
        let record = closed_loop::run(DEMONSTRATION.at_rest(), &Position::DEMONSTRATION, &sequence, |signals| {
            let v_add = block.step(signals);
            assert_eq!((block.get("fault"), block.get("error_id")), (0.0, 0.0), "{signals:?}");
            v_add_calculated.push(block.get("v_add_calculated"));
            was_limited |= block.get("limited") != 0.0;
            v_add
        });
        Move { record, v_add_calculated, was_limited }
    }

    /// Saves the move as a recorder would, with these signals.
    pub fn write_moves(&self, file: &str, names: &[String], record: &Record) {
        let value = |name: &str, n: usize| match name {
            "x_command" => record.command[n] * 1e3,
            "x_actual" => record.seen[n] * 1e3,
            "v_command" => record.signals[n].v_command,
            "v_direct" => record.signals[n].v_direct,
            "v_motor" => record.signals[n].v_motor,
            "a_load" => record.sensor[n],
            other => panic!("page: no signal {other}"),
        };
        let mut text = format!("time [s],{}\n", names.join(","));
        for n in 0..record.command.len() {
            let row = names.iter().map(|name| format!("{:.6}", value(name, n)));
            text += &format!("{:.3},{}\n", n as f64 * record.cycle, row.collect::<Vec<_>>().join(","));
        }
        fs::write(self.path(file), text).unwrap();
    }

    /// A recorder on the controller starts.
    pub fn start_recording(&mut self) {
        self.block.record_anew();
    }

    /// Everything that went in and came out since then.
    pub fn save(&self, name: &str) {
        fs::write(self.path(name), self.block.csv()).unwrap();
    }
}

impl Move {
    /// Amplitude within a band [Hz] of the motor's velocity while it vibrates, at constant speed [um/s].
    pub fn of_motor(&self, band: [f64; 2]) -> f64 {
        let v: Vec<f64> = self.record.signals.iter().map(|signals| signals.v_motor).collect();
        mean(dwells(&self.record).map(|window| amplitude(&v[window], self.record.cycle, band)))
    }

    /// Amplitude within a band [Hz] of the sensor at the load, around the ramps [m/s^2].
    pub fn of_load_at_ramps(&self, band: [f64; 2]) -> f64 {
        mean(ramps(&self.record).map(|window| amplitude(&self.record.sensor[window], self.record.cycle, band)))
    }

    /// The same at constant speed.
    pub fn of_load_at_speed(&self, band: [f64; 2]) -> f64 {
        mean(dwells(&self.record).map(|window| amplitude(&self.record.sensor[window], self.record.cycle, band)))
    }

    /// The largest |value|, of the last half second and of the whole move.
    pub fn rest_and_peak(&self, of: &[f64]) -> [f64; 2] {
        [peak(&of[of.len() - 500..]), peak(of)]
    }

    /// The shortest window of constant speed, as cycles of the record.
    pub fn dwell(&self) -> std::ops::Range<usize> {
        dwells(&self.record).next().unwrap()
    }
}

pub fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let values: Vec<f64> = values.collect();
    values.iter().sum::<f64>() / values.len() as f64
}
