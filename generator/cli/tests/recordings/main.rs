//! Recordings as users have them: how a scope writes them, what they prove, and which mistake explains that they differ.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod evidence;
mod mistakes;
mod refused;
mod spellings;

use std::fs;
use std::path::Path;
use std::process::Command;

/// Two axes of one kind: X follows the motor and the command, Y has other frequencies.
const SET: &str = r#"cycle_time = "1ms"
[axis.X]
kopf.achs_nr = 1
getriebe = [{ dynamik.vb_max = 400000 }]
[axis.X.lr_param.improved_position_control]
enable = "ON"
v_add_max_fact = 500
[[axis.X.lr_param.improved_position_control.stage]]
mode = "DIRECT"
weight_fact_num = 80
weight_fact_denom = 100
filter = [{ order = 1, fg_f0 = 53.0, q_factor = 4.0 }]
[[axis.X.lr_param.improved_position_control.stage]]
mode = "SET_POINT"
osc_damping = 0.8
weight_fact_num = 72
weight_fact_denom = 100
filter = [{ order = 1, fg_f0 = 17.0, q_factor = 3.0 }]
[axis.Y]
kopf.achs_nr = 2
getriebe = [{ dynamik.vb_max = 400000 }]
[axis.Y.lr_param.improved_position_control]
enable = "ON"
v_add_max_fact = 500
[[axis.Y.lr_param.improved_position_control.stage]]
mode = "DIRECT"
weight_fact_num = 80
weight_fact_denom = 100
filter = [{ order = 1, fg_f0 = 41.0, q_factor = 4.0 }]
"#;

/// What came of a command.
struct Run {
    code: i32,
    out: String,
    err: String,
}

fn axgen(folder: &Path, arguments: &[&str]) -> Run {
    let output = Command::new(env!("CARGO_BIN_EXE_axgen")).current_dir(folder).args(arguments).output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    Run { code: output.status.code().unwrap(), out, err }
}

/// A folder with the set.
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

    /// Only these columns.
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
fn good(folder: &Path) -> Recording {
    Recording::of(folder, "axes.toml", "X", None).only(&["v_command", "v_motor", "v_add", "v_add_calculated"])
}

/// Compares a text with the block of X.
fn compare(folder: &Path, text: impl AsRef<[u8]>, more: &[&str]) -> Run {
    fs::write(folder.join("recorded.csv"), text).unwrap();
    axgen(folder, &[&["run", "axes.toml", "--axis", "X", "--compare", "recorded.csv"], more].concat())
}
