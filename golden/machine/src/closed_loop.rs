//! A machine in the position loop of a CNC: moves in, a record out. Improved position control is a closure of the caller.
//!
//! ```text
//! sequence --x, v--> position controller --v_command--(+)--v_cmd--> machine --+
//!                        ^                             ^                      |
//!                        |                           v_add <-- closure        |
//!                        +----------------------------------------------------+
//! ```
//!
//! The machine is in metres; the closure sees um/s, as a controller does.

use super::machine::{Machine, Measured};
use super::sequence::{Planned, Sequence};

/// Micrometres of a metre.
pub const UM: f64 = 1e6;

/// The position controller of the CNC: `v_command = Kv (x - x_actual) + feedforward v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// gain Kv [1/s]
    pub kv: f64,
    /// fraction of the planned velocity that is fed forward
    pub feedforward: f64,
}

impl Position {
    /// The position controller of the demonstration plant.
    pub const DEMONSTRATION: Self = Self { kv: 20.0, feedforward: 1.0 };

    /// The signals of the controller and of improved position control in a cycle, from a position command [m], its velocity
    /// [m/s] and actual values.
    #[must_use]
    pub fn signals(&self, x: f64, v: f64, actual: &Measured) -> Signals {
        let v_command = self.kv * (x - actual.x) + self.feedforward * v;
        Signals { v_command: v_command * UM, v_motor: actual.v_motor * UM, v_direct: actual.v_load * UM }
    }
}

/// The inputs of improved position control in a cycle [um/s].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Signals {
    /// output of the position controller with feedforward, before v_add is added
    pub v_command: f64,
    /// velocity of the motor
    pub v_motor: f64,
    /// velocity of the load
    pub v_direct: f64,
}

/// The signals of each cycle, and the ramps.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// cycle time Ts [s]
    pub cycle: f64,
    /// each ramp at the drive, later than planned by the delays of the machine: its first cycle, and the one after its last
    pub ramps: Vec<[usize; 2]>,
    /// the position command [m]
    pub command: Vec<f64>,
    /// the planned velocity [m/s]
    pub v_planned: Vec<f64>,
    /// the motor's position [m]
    pub x: Vec<f64>,
    /// the motor's position as the controller sees it, a cycle later [m]
    pub seen: Vec<f64>,
    /// the measured acceleration of the load [m/s^2]
    pub sensor: Vec<f64>,
    /// the inputs of the closure
    pub signals: Vec<Signals>,
    /// the outputs of the closure [um/s]
    pub v_add: Vec<f64>,
}

/// Runs a sequence from standstill. The closure gets the signals of each cycle [um/s] and returns `v_add` [um/s] in the same
/// cycle.
#[must_use]
pub fn run(
    mut machine: impl Machine,
    position: &Position,
    sequence: &Sequence,
    mut ipc: impl FnMut(&Signals) -> f64,
) -> Record {
    let (cycle, late) = (machine.cycle(), machine.delay_cycles());
    let Planned { ramps, x, v } = sequence.planned(cycle);
    let ramps = ramps.into_iter().map(|ramp| ramp.map(|at| at + late)).collect();
    let mut record = Record { cycle, ramps, ..Record::default() };
    let mut actual = Measured::default();
    for (x, v) in x.into_iter().zip(v) {
        let now = machine.now();
        let signals = position.signals(x, v, &actual);
        let v_add = ipc(&signals);
        record.seen.push(actual.x);
        actual = machine.step((signals.v_command + v_add) / UM);
        record.command.push(x);
        record.v_planned.push(v);
        record.x.push(now.x);
        record.sensor.push(now.a_load);
        record.signals.push(signals);
        record.v_add.push(v_add);
    }
    record
}
