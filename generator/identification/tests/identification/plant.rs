//! The demonstration plant as the tests record it: its exact response, its excitation in the closed position loop,
//! noise. No assertion.

use identification::Complex64;
use identification::excitation::Excitation;
use machine::closed_loop::{self, Position, UM};
use machine::measure::{Figures, figures, fourier};
use machine::mechanics::{Mechanics, Mesh};
use machine::plant::{DEMONSTRATION, Plant};
use machine::sequence::Sequence;
use machine::{Machine, Measured};
use std::f64::consts::TAU;

/// Cycle of the position controller [s].
pub const CYCLE: f64 = 1e-3;
/// Cycles of an impulse response: 16 s, in which every vibration of the plant is gone.
const CYCLES: usize = 16_384;

/// White noise of a rms value, the same in every run: splitmix64, Box and Muller.
pub struct Noise {
    state: u64,
    rms: f64,
}

impl Noise {
    pub fn new(seed: u64, rms: f64) -> Self {
        Self { state: seed, rms }
    }

    /// Evenly in (0, 1].
    pub fn even(&mut self) -> f64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (((z ^ (z >> 31)) >> 11) + 1) as f64 / (1_u64 << 53) as f64
    }

    pub fn next(&mut self) -> f64 {
        let (a, b) = (self.even(), self.even());
        self.rms * (-2.0 * libm::log(a)).sqrt() * libm::cos(TAU * b)
    }

    /// Added to all values.
    pub fn on(&mut self, values: &[f64]) -> Vec<f64> {
        values.iter().map(|value| value + self.next()).collect()
    }
}

/// The answers of a linear plant to an impulse of `v_cmd`, from sampling instant to sampling instant.
pub struct Impulse {
    v_motor: Vec<f64>,
    a_load: Vec<f64>,
    /// how the position of the motor changes
    moved: Vec<f64>,
}

impl Impulse {
    pub fn of(plant: &Plant) -> Self {
        Self::of_cycles(plant, CYCLES)
    }

    pub fn of_cycles(plant: &Plant, cycles: usize) -> Self {
        let mut machine = plant.without_mesh().at_rest();
        let mut answer = Self { v_motor: vec![0.0], a_load: vec![0.0], moved: vec![0.0] };
        let mut before = 0.0;
        for n in 0..cycles {
            let measured = machine.step(if n == 0 { 1.0 } else { 0.0 });
            answer.v_motor.push(measured.v_motor);
            answer.a_load.push(measured.a_load);
            answer.moved.push(measured.x - before);
            before = measured.x;
        }
        answer
    }

    /// P at a frequency [Hz].
    pub fn p(&self, hz: f64) -> Complex64 {
        let [re, im] = fourier(&self.v_motor, TAU * hz * CYCLE);
        Complex64::new(re, im)
    }

    /// P at k/(N T), k = 1..=N/2.
    pub fn lines(&self, period: u32) -> Vec<Complex64> {
        (1..=period / 2).map(|k| self.p(f64::from(k) / (f64::from(period) * CYCLE))).collect()
    }

    /// From `v_cmd` to the position of the motor: its changes, summed.
    pub fn of_position(&self, hz: f64) -> Complex64 {
        let [re, im] = fourier(&self.moved, TAU * hz * CYCLE);
        Complex64::new(re, im) / (1.0 - Complex64::from_polar(1.0, -TAU * hz * CYCLE))
    }

    /// From `v_cmd` to the acceleration of the load.
    pub fn of_load(&self, hz: f64) -> Complex64 {
        let [re, im] = fourier(&self.a_load, TAU * hz * CYCLE);
        Complex64::new(re, im)
    }
}

/// What is recorded while an axis is excited, in metres and seconds: the measured periods.
#[derive(Default)]
pub struct Excited {
    pub v_cmd: Vec<f64>,
    pub v_motor: Vec<f64>,
    pub a_load: Vec<f64>,
}

/// Excites the plant in its position loop while it moves at a speed [m/s].
pub fn excited(plant: &Plant, excitation: &Excitation, speed: f64) -> Excited {
    let mut machine = plant.at_rest();
    let (mut actual, mut x, mut record) = (Measured::default(), 0.0, Excited::default());
    let settle = (0.5 / CYCLE) as usize;
    let measured = excitation.measured();
    let samples: Vec<f64> = std::iter::repeat_n(0.0, settle).chain(excitation.samples()).collect();
    for (n, excite) in samples.into_iter().enumerate().take(settle + measured.end) {
        x += speed * CYCLE;
        let v_cmd = Position::DEMONSTRATION.signals(x, speed, &actual).v_command / UM + excite;
        let read = actual;
        actual = machine.step(v_cmd);
        if n >= settle + measured.start {
            record.v_cmd.push(v_cmd);
            record.v_motor.push(read.v_motor);
            record.a_load.push(read.a_load);
        }
    }
    record
}

/// A move of the demonstration plant, with its figures in metres and seconds.
pub struct Move {
    pub v_command: Vec<f64>,
    pub v_motor: Vec<f64>,
    pub a_load: Vec<f64>,
    /// command less position of the motor
    pub error: Vec<f64>,
}

/// The moves forward and back, with a closure as improved position control (`v_motor` in, `v_add` out, m/s), whose
/// figures come with them.
pub fn moved(plant: &Plant, mut ipc: impl FnMut(f64) -> f64) -> (Move, Figures) {
    let record = closed_loop::run(plant.at_rest(), &Position::DEMONSTRATION, &Sequence::DEMONSTRATION, |signals| {
        ipc(signals.v_motor / UM) * UM
    });
    let of_record = Move {
        v_command: record.v_planned.clone(),
        v_motor: record.signals.iter().map(|signals| signals.v_motor / UM).collect(),
        a_load: record.sensor.clone(),
        error: record.command.iter().zip(&record.x).map(|(command, x)| command - x).collect(),
    };
    (of_record, figures(&record))
}

/// A value between two, evenly on a logarithmic scale.
fn between_two(noise: &mut Noise, [low, high]: [f64; 2]) -> f64 {
    low * libm::pow(high / low, noise.even())
}

/// An axis with a stiff drive whose bed and carriage vibrate somewhere.
pub fn random_axis(seed: u64) -> Plant {
    let mut noise = Noise::new(seed, 1.0);
    let mut of = |range| between_two(&mut noise, range);
    let [m1, m2, m3] = [of([300.0, 1500.0]), of([500.0, 3000.0]), of([3000.0, 12_000.0])];
    let (contact, bed) = (TAU * of([35.0, 120.0]), TAU * of([7.0, 25.0]));
    let (k1, k2) = (m1 * m2 / (m1 + m2) * contact * contact, (m2 + m3) * bed * bed);
    let (c1, c2) = (2.0 * of([0.03, 0.1]) * k1 / contact, 2.0 * of([0.02, 0.08]) * k2 / bed);
    let mechanics =
        Mechanics { m1, m2, m3, k1, c1, k2, c2, mesh: Mesh { force: 0.0, pitch: 0.01 }, current_lag: 0.4e-3 };
    let (command_delay, actual_delay) = (of([1.0, 3.99]) as usize, of([1.0, 2.99]) as usize - 1);
    Plant {
        mechanics,
        kp: m1 * of([400.0, 900.0]),
        tn: of([15e-3, 40e-3]),
        command_delay,
        actual_delay,
        ..DEMONSTRATION
    }
}

pub fn degrees(value: Complex64) -> f64 {
    libm::atan2(value.im, value.re).to_degrees()
}
