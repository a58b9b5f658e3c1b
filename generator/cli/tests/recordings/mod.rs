//! Recordings as users have them: how a scope writes them, what they prove, and which mistake explains that they differ.

mod evidence;
mod mistakes;
mod refused;
mod spellings;

use crate::{Run, axgen};
use std::{fs, path::Path, sync::LazyLock};

/// Two axes of one kind: X follows the motor and the command, Y has other frequencies.
const SET: &str = include_str!("axes.toml");

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("axes.toml"), SET).unwrap();
    folder
}

/// Columns by their names, cycle by cycle.
#[derive(Clone)]
struct Recording {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Recording {
    /// What an axis of a set answers to a move that begins at rest; rounded to a number of decimals, if any.
    fn of(folder: &Path, set: &str, axis: &str, decimals: Option<usize>) -> Self {
        let time = |cycle: u32| f64::from(cycle) / 1000.0;
        let rounded = |value: f64| decimals.map_or(value, |decimals| format!("{value:.decimals$}").parse().unwrap());
        let inputs = (0..3000).map(|cycle| {
            let ramp = 40_000.0 * (time(cycle) * 4.0).min(1.0);
            let motor = ramp + 300.0 * (time(cycle) * 333.0).sin() + f64::from(cycle * 37 % 11) * time(cycle);
            vec![rounded(ramp + 90.0 * (time(cycle) * 107.0).sin()), rounded(motor)]
        });
        let mut recording =
            Self { names: ["v_command", "v_motor"].map(str::to_owned).to_vec(), rows: inputs.collect() };
        fs::write(folder.join("inputs.csv"), recording.csv()).unwrap();
        let run = axgen(folder, &["run", set, "--axis", axis, "--stimulus", "inputs.csv"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let mut lines = run.out.lines();
        recording.names.extend(lines.next().unwrap().split(',').map(str::to_owned));
        for (row, line) in recording.rows.iter_mut().zip(lines) {
            row.extend(line.split(',').map(|cell| rounded(cell.parse().unwrap())));
        }
        recording
    }

    fn only(&self, names: &[&str]) -> Self {
        let at: Vec<usize> = names.iter().map(|name| self.at(name)).collect();
        let row = |row: &Vec<f64>| at.iter().map(|at| row[*at]).collect();
        Self { names: names.iter().map(|name| (*name).to_owned()).collect(), rows: self.rows.iter().map(row).collect() }
    }

    fn at(&self, name: &str) -> usize {
        self.names.iter().position(|known| known == name).unwrap()
    }

    fn csv(&self) -> String {
        let row = |row: &Vec<f64>| row.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n";
        self.names.join(",") + "\n" + &self.rows.iter().map(row).collect::<String>()
    }
}

/// A good recording of X: v_command, v_motor, v_add, v_add_calculated, with all digits.
fn good() -> Recording {
    static GOOD: LazyLock<Recording> = LazyLock::new(|| {
        Recording::of(folder().path(), "axes.toml", "X", None).only(&[
            "v_command",
            "v_motor",
            "v_add",
            "v_add_calculated",
        ])
    });
    GOOD.clone()
}

/// Compares a text with the block of X.
fn compare(folder: &Path, text: impl AsRef<[u8]>, more: &[&str]) -> Run {
    fs::write(folder.join("recorded.csv"), text).unwrap();
    axgen(folder, &[&["run", "axes.toml", "--axis", "X", "--compare", "recorded.csv"], more].concat())
}
