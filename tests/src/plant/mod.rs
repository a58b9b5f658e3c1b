//! The demonstration plant: a rack-and-pinion axis on which the application example of the manual comes true, and how its vibrations
//! are measured. No block is here: improved position control is a closure of the caller.
//!
//! ```text
//! sequence --x, v--> position controller --v_soll--(+)--v_cmd--> delay --> velocity loop --> current loop --> mechanics --+
//!                        ^                          ^                                                                     |
//!                        |                        v_add <-- closure (v_soll, v_ist1, v_ist2)                              |
//!                        +---------------------------------- delay <------------------------------------------------------+
//! ```
//!
//! It is one plant of a random search. It shows that the documented result is possible, not that it is typical.
//! Metres, seconds, newtons and kilograms inside; the closure sees um/s, as a controller does. Sines are libm's: the same bits on every
//! host.
//!
//! ```text
//! mechanics    three masses, two springs, an excitation; the current loop
//! control      velocity loop of the drive, position controller of the CNC, delays: one cycle
//! sequence     the moves: what an interpolator gives
//! measure      a record -> the amplitudes that the table of the application example has
//! sensitivity  the open loop by its impulse response: Ms, gain margin
//! subject      a set or a list -> its block `ipc`, as the closure
//! ```

pub mod control;
pub mod measure;
pub mod mechanics;
pub mod sensitivity;
pub mod sequence;
pub mod subject;

pub use control::{Control, Machine, Signals};
pub use mechanics::Mechanics;
pub use sequence::Sequence;

use sequence::Planned;

/// The whole plant. What is not said by its default is what a caller varies: `Plant { control: Control { actual_delay: 2, .. }, .. }`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plant {
    /// masses, springs, excitation, current loop
    pub mechanics: Mechanics,
    /// the loops of drive and CNC
    pub control: Control,
}

impl Plant {
    /// The same with another mass of the carriage, m2 times the factor.
    #[must_use]
    pub fn with_mass_factor(self, factor: f64) -> Self {
        let Self { mechanics, control } = self;
        Self { mechanics: Mechanics { m2: mechanics.m2 * factor, ..mechanics }, control }
    }
}

/// What was seen in each cycle, and where the ramps are.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// cycle time Ts [s]
    pub cycle: f64,
    /// each ramp as the drive sees it, the delays of the loop later than planned: its first cycle, and the one behind its last
    pub ramps: Vec<[usize; 2]>,
    /// the position command [m]
    pub command: Vec<f64>,
    /// the planned velocity [m/s]
    pub v_command: Vec<f64>,
    /// the motor's position [m]
    pub q1: Vec<f64>,
    /// the acceleration of the carriage x2'', which the sensor measures [m/s^2]
    pub sensor: Vec<f64>,
    /// what the closure saw
    pub signals: Vec<Signals>,
    /// what the closure added [um/s]
    pub v_add: Vec<f64>,
}

/// Runs a sequence from standstill. The closure gets the signals of each cycle [um/s] and gives `v_add` [um/s] in the same cycle.
#[must_use]
pub fn run(plant: &Plant, sequence: &Sequence, mut ipc: impl FnMut(&Signals) -> f64) -> Record {
    let Control { cycle, actual_delay, command_delay, .. } = plant.control;
    let Planned { ramps, x, v } = sequence.planned(cycle);
    let ramps = ramps.into_iter().map(|ramp| ramp.map(|at| at + actual_delay + command_delay)).collect();
    let mut record = Record { cycle, ramps, ..Record::default() };
    let mut machine = Machine::new(plant);
    for (x, v) in x.into_iter().zip(v) {
        record.q1.push(machine.mechanics.q1());
        record.sensor.push(machine.sensor());
        let signals = machine.sample(x, v);
        let v_add = ipc(&signals);
        machine.advance(signals.v_soll + v_add);
        record.command.push(x);
        record.v_command.push(v);
        record.signals.push(signals);
        record.v_add.push(v_add);
    }
    record
}
