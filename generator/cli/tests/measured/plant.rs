//! Recordings of the simulated demonstration plant, moved and excited, and the command that reads them.

use machine::closed_loop::{Position, UM};
use machine::plant::DEMONSTRATION;
use machine::sequence::Sequence;
use machine::{Machine, Measured};
use serde_json::Value;
use std::fmt::Write;

pub const CYCLE: f64 = 1e-3;
pub const X_COMMAND: usize = 0;
pub const X_ACTUAL: usize = 1;
pub const V_COMMAND: usize = 2;
pub const V_MOTOR: usize = 3;
pub const V_CMD: usize = 4;
pub const V_EXCITE: usize = 5;
pub const A_LOAD: usize = 6;

pub const OF_MOVES: [usize; 5] = [X_COMMAND, X_ACTUAL, V_COMMAND, V_MOTOR, A_LOAD];
pub const OF_EXCITED: [usize; 4] = [V_CMD, V_MOTOR, V_EXCITE, A_LOAD];

/// Columns, as the task of the position controller records them: um/s, mm, m/s^2.
pub type Columns = [Vec<f64>; 7];

/// The demonstration plant in its position loop, by a planned position [m] and velocity, and what is added to its command [m/s].
pub fn recorded(x: &[f64], v: &[f64], excite: &[f64]) -> Columns {
    let mut machine = DEMONSTRATION.at_rest();
    let mut actual = Measured::default();
    let mut columns = Columns::default();
    for ((x, v), excite) in x.iter().zip(v).zip(excite) {
        let signals = Position::DEMONSTRATION.signals(*x, *v, &actual);
        let v_cmd = signals.v_command / UM + excite;
        let [x, x_actual] = [*x, actual.x].map(|x| x * 1e3);
        let row = [x, x_actual, signals.v_command, signals.v_motor, v_cmd * UM, excite * UM, actual.a_load];
        columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
        actual = machine.step(v_cmd);
    }
    columns
}

/// The moves of the demonstration: the sequence of its figures.
pub fn moves() -> Columns {
    let planned = Sequence::DEMONSTRATION.planned(CYCLE);
    recorded(&planned.x, &planned.v, &vec![0.0; planned.x.len()])
}

/// Excited with 5 mm/s while it moves at a speed, 0.5 s after the start: a register of 11 bits, clocks of 2 cycles.
pub fn excited(periods: usize, speed: f64) -> Columns {
    let (mut register, mut signs) = (0x7ff_u32, Vec::new());
    for _ in 0..2047 {
        let sign = if register >> 10 & 1 == 1 { 1.0 } else { -1.0 };
        signs.extend([sign; 2]);
        register = (register << 1 | (register >> 10 ^ register >> 8) & 1) & 0x7ff;
    }
    let full = (periods + 1) * 4094;
    let part = |n: usize| n.min(100).min(full + 100 - n) as f64 / 100.0;
    let excite = (0..full + 100).map(|n| 5e-3 * part(n) * signs[n % 4094]);
    let excite: Vec<f64> = std::iter::repeat_n(0.0, 500).chain(excite).chain([0.0; 100]).collect();
    let x: Vec<f64> = (1..=excite.len()).map(|n| n as f64 * speed * CYCLE).collect();
    recorded(&x, &vec![speed; x.len()], &excite)
}

/// White noise with an rms value of 1: a linear congruence, twelve of its values each.
pub struct Noise(pub u64);

impl Noise {
    pub fn next(&mut self) -> f64 {
        let mut even = || {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| even()).sum::<f64>() - 6.0
    }
}

/// Columns under these names as CSV with a time.
pub fn csv(names: &[&str; 7], columns: &Columns, of: &[usize]) -> String {
    let mut text = format!("time [s],{}\n", of.iter().map(|at| names[*at]).collect::<Vec<_>>().join(","));
    for (n, _) in columns[of[0]].iter().enumerate() {
        write!(text, "{:.3}", n as f64 * CYCLE).unwrap();
        of.iter().for_each(|at| write!(text, ",{:.6}", columns[*at][n]).unwrap());
        text.push('\n');
    }
    text
}

pub fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value:#}"))
}
