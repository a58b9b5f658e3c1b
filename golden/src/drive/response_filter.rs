//! A measured response as a machine: the velocity of the motor is the command filtered by its impulse response. No file, no
//! parameter.

use machine::{Machine, Measured};
use portable::Extreme;
use stability::{Complex64, Response, magnitude, turned};
use std::f64::consts::TAU;

/// Length of an impulse response [s], and its maximum number of cycles: a longer decay is cut off, which the deviation
/// shows.
const LENGTH: f64 = 4.0;
const MOST: usize = 16_384;
/// The last values are left out if their sum is below this part of the total.
const NEGLIGIBLE: f64 = 1e-7;
/// Partial sums computed in parallel, so that the compiler can vectorise them.
const LANES: usize = 8;

/// A measured drive in operation.
#[derive(Clone, Debug)]
pub struct ResponseFilter {
    cycle: f64,
    /// Kv [1/s] of a drive that controls the position
    gain: Option<f64>,
    /// the impulse response, the latest value first; the last one acts one cycle after its command
    taps: Vec<f64>,
    /// all commands, preceded by one zero per tap
    commands: Vec<f64>,
    now: Measured,
}

impl ResponseFilter {
    /// At rest, from the inverse transform of the response on an even grid from 0 Hz to the Nyquist frequency. The part of
    /// the response before its command, or in the same cycle, is impossible for a machine: it is left out.
    #[must_use]
    pub fn new(response: &Response, cycle: f64, gain: Option<f64>) -> Self {
        let impulse = impulse(|hz| without_loop(response, gain, hz), cycle);
        let all: f64 = impulse.iter().map(|value| value.abs()).sum();
        let mut rest = 0.0;
        let late = impulse.iter().rev().take_while(|value| {
            rest += value.abs();
            rest <= NEGLIGIBLE * all
        });
        let length = (impulse.len() - late.count()).max(2);
        let mut taps: Vec<f64> = impulse[1..length].iter().rev().copied().collect();
        if gain.is_some() {
            // No controller outside corrects the position: the axis must come to rest where it is commanded.
            let sum: f64 = taps.iter().sum();
            taps.iter_mut().for_each(|tap| *tap /= sum);
        }
        Self { cycle, gain, commands: vec![0.0; taps.len()], taps, now: Measured::default() }
    }

    /// The largest difference from the measured response at its lines, relative to its largest magnitude; and the frequency
    /// [Hz].
    #[must_use]
    pub fn deviation(&self, response: &Response) -> [f64; 2] {
        let (mut worst, mut at, mut largest) = (0.0, 0.0, f64::MIN_POSITIVE);
        let lines = response.frequencies().iter().filter(|hz| **hz * self.cycle <= 0.5);
        for hz in lines {
            let wanted = without_loop(response, self.gain, *hz);
            let difference = magnitude(self.value(*hz) - wanted);
            largest = magnitude(wanted).larger(largest);
            if difference > worst {
                (worst, at) = (difference, *hz);
            }
        }
        [worst / largest, at]
    }

    /// Its own response at a frequency [Hz].
    fn value(&self, hz: f64) -> Complex64 {
        let turn = turned(-TAU * hz * self.cycle);
        // Horner's method: the latest value is the highest power.
        self.taps.iter().fold(Complex64::new(0.0, 0.0), |sum, tap| (sum + tap) * turn)
    }
}

/// The response without the factor j w/(j w + Kv) of the position loop, which is closed in each cycle.
fn without_loop(response: &Response, gain: Option<f64>, hz: f64) -> Complex64 {
    match gain {
        Some(gain) if hz > 0.0 => response.value(hz) * Complex64::new(1.0, -gain / (TAU * hz)),
        Some(_) => Complex64::new(1.0, 0.0),
        None => response.value(hz),
    }
}

/// The first half of the inverse transform: the second one would be before the command.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand cycles")]
fn impulse(response: impl Fn(f64) -> Complex64, cycle: f64) -> Vec<f64> {
    let half = ((LENGTH / cycle) as usize).clamp(LANES, MOST).next_power_of_two() / 2;
    let length = 2 * half;
    let turns: Vec<Complex64> = (0..length).map(|n| turned(TAU * n as f64 / length as f64)).collect();
    let lines: Vec<Complex64> = (0..=half)
        .map(|k| {
            let value = response(k as f64 / (length as f64 * cycle));
            // The lines at both ends occur once, the others also as their mirror images.
            if k == 0 || k == half { value } else { value * 2.0 }
        })
        .collect();
    let at = |n: usize| {
        let sum = lines.iter().enumerate().map(|(k, line)| {
            let turn = turns[k * n % length];
            line.re * turn.re - line.im * turn.im
        });
        sum.sum::<f64>() / length as f64
    };
    (0..half).map(at).collect()
}

impl Machine for ResponseFilter {
    fn cycle(&self) -> f64 {
        self.cycle
    }

    /// The cycle of the largest value, after the cycle in which a command is held.
    fn delay_cycles(&self) -> usize {
        let largest = (0..self.taps.len()).max_by(|a, b| self.taps[*a].abs().total_cmp(&self.taps[*b].abs()));
        self.taps.len() - 1 - largest.unwrap_or(0)
    }

    fn now(&self) -> Measured {
        self.now
    }

    fn step(&mut self, v_cmd: f64) -> Measured {
        let gain = self.gain.unwrap_or(0.0);
        // As in the machine `Drive`: the command of the position, not of its deviation.
        self.commands.push(v_cmd + gain * self.now.x);
        let latest = &self.commands[self.commands.len() - self.taps.len()..];
        let (before, mut v) = (self.now, product(latest, &self.taps));
        if gain > 0.0 {
            // dx/dt = v - Kv x over a cycle; its mean.
            v = (v / gain - before.x) * (1.0 - libm::exp(-gain * self.cycle)) / self.cycle;
        }
        let (x, a_load) = (before.x + v * self.cycle, (v - before.v_motor) / self.cycle);
        self.now = Measured { x, v_motor: v, v_load: v, a_load };
        self.now
    }
}

/// The sum of the products.
fn product(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (a, b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in a.zip(b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    rest + sums.iter().sum::<f64>()
}
