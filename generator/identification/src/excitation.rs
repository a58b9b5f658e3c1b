//! The signal that excites an axis: a maximum-length sequence; and its effects on the machine.

use portable::Extreme;
use std::f64::consts::PI;

/// Duration of a clock of the default excitation [s].
const CLOCK: f64 = 2e-3;
/// Minimum duration of its period [s].
pub const PERIOD: f64 = 4.0;
/// Default number of measured periods.
pub const PERIODS: usize = 8;
/// Default amplitude, for velocities in m/s.
pub const AMPLITUDE: f64 = 2e-3;
/// Rise time and fall time of the excitation [s].
pub const FADE: f64 = 0.1;
/// Minimum number of lines within the half-power width of a vibration.
const LINES_IN_WIDTH: f64 = 4.0;
/// Minimum speed of the move during the excitation, in amplitudes: friction keeps its sign.
pub const LEAST_SPEED: f64 = 2.5;

/// Tapped bits of the shift registers from 7 bits on, counted from the front: all with the longest period, 2^n - 1 clocks.
const TAPS: [&[u32]; 9] = [
    &[7, 6],
    &[8, 6, 5, 4],
    &[9, 5],
    &[10, 7],
    &[11, 9],
    &[12, 11, 10, 4],
    &[13, 12, 11, 8],
    &[14, 13, 12, 2],
    &[15, 14],
];
/// The smallest and the largest number of bits.
const BITS: [u32; 2] = [7, 15];

/// A maximum-length sequence.
///
/// A register of n bits starts with ones. A clock outputs the last bit, 1 as +1 and 0 as -1, then shifts the exclusive-or of
/// the tapped bits in at the front. A clock lasts c cycles: the period is N = (2^n - 1) c cycles, and its sum is one clock.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Sequence {
    bits: u32,
    clock: u32,
}

/// Cycles of a clock by default: max(1, round(2 ms / T)).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn usual_clock(cycle_time: f64) -> u32 {
    libm::round(CLOCK / cycle_time).larger(1.0) as u32
}

impl Sequence {
    /// A sequence with a register of 7 to 15 bits and clocks of at least one cycle; `None` for other numbers.
    #[must_use]
    pub fn new(bits: u32, clock: u32) -> Option<Self> {
        (BITS[0]..=BITS[1]).contains(&bits).then_some(())?;
        (clock > 0).then_some(Self { bits, clock })
    }

    /// The sequence for a cycle time T [s]: c = max(1, round(2 ms / T)), and the smallest number of bits with N T >= 4 s.
    #[must_use]
    pub fn for_cycle(cycle_time: f64) -> Self {
        Self::with_clock(usual_clock(cycle_time), cycle_time)
    }

    /// The sequence for a cycle time, with a line distance of at most a quarter of the half-power width 2 zeta f of the
    /// slowest vibration [Hz].
    #[must_use]
    pub fn for_vibration(cycle_time: f64, hz: f64, damping: f64) -> Self {
        let spacing = 2.0 * damping * hz / LINES_IN_WIDTH;
        Self::shortest(usual_clock(cycle_time), cycle_time, PERIOD.larger(1.0 / spacing))
    }

    /// With clocks of c cycles, at least one: the fewest bits with N T >= 4 s, else the most.
    #[must_use]
    pub fn with_clock(clock: u32, cycle_time: f64) -> Self {
        Self::shortest(clock, cycle_time, PERIOD)
    }

    fn shortest(clock: u32, cycle_time: f64, period: f64) -> Self {
        let of = |bits| Self { bits, clock };
        let is_long = |bits: &u32| of(*bits).period() as f64 * cycle_time >= period;
        of((BITS[0]..=BITS[1]).find(is_long).unwrap_or(BITS[1]))
    }

    /// Bits of the register n.
    #[must_use]
    pub fn bits(&self) -> u32 {
        self.bits
    }

    /// Cycles of a clock c.
    #[must_use]
    pub fn clock(&self) -> u32 {
        self.clock
    }

    /// Cycles of a period N.
    #[must_use]
    pub fn period(&self) -> usize {
        ((1 << self.bits) - 1) * self.clock as usize
    }

    /// The distance of its lines 1/(N T) [Hz].
    #[must_use]
    pub fn spacing(&self, cycle_time: f64) -> f64 {
        1.0 / (self.period() as f64 * cycle_time)
    }

    /// Half the frequency of its clocks 1/(2 c T) [Hz]: every line below is strong.
    #[must_use]
    pub fn half_clock(&self, cycle_time: f64) -> f64 {
        0.5 / (f64::from(self.clock) * cycle_time)
    }

    /// The endless signal of +1 and -1, cycle by cycle.
    pub fn signs(&self) -> impl Iterator<Item = f64> + use<> {
        let Self { bits, clock } = *self;
        let taps = TAPS[(bits - BITS[0]) as usize];
        let mask = (1_u32 << bits) - 1;
        let next = move |register: &u32| {
            let fed = taps.iter().fold(0, |sum, tap| sum ^ (register >> (tap - 1)));
            Some((register << 1 | fed & 1) & mask)
        };
        let sign = move |register: u32| if register >> (bits - 1) & 1 == 1 { 1.0 } else { -1.0 };
        std::iter::successors(Some(mask), next)
            .flat_map(move |register| std::iter::repeat_n(sign(register), clock as usize))
    }

    /// The amplitude of the line k of the period, k = 1..=N/2, of the sequence of amplitude 1: 2 |U_k| / N.
    ///
    /// |U_k| = sqrt(2^n) sin(pi k c / N) / sin(pi k / N): equal for all lines except for the hold of a clock.
    #[must_use]
    pub fn line(&self, k: usize) -> f64 {
        let turn = PI * k as f64 / self.period() as f64;
        let hold = libm::fabs(libm::sin(turn * f64::from(self.clock)) / libm::sin(turn));
        2.0 * f64::from(1_u32 << self.bits).sqrt() * hold / self.period() as f64
    }
}

/// An excitation, which is added to the commanded velocity, in the unit of its amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excitation {
    pub sequence: Sequence,
    /// T [s]
    pub cycle_time: f64,
    /// A
    pub amplitude: f64,
    /// measured periods M, after one in which the axis settles
    pub periods: usize,
}

impl Excitation {
    /// v_excite = A g s, cycle by cycle to its end: g rises from 0 to 1 in 0.1 s, and falls in 0.1 s after the last period.
    pub fn samples(&self) -> impl Iterator<Item = f64> + use<> {
        let (fade, full, amplitude) = (self.fade(), (self.periods + 1) * self.sequence.period(), self.amplitude);
        let part = move |n: usize| n.min(fade).min(full + fade - n) as f64 / fade as f64;
        self.sequence.signs().take(full + fade).enumerate().map(move |(n, sign)| amplitude * part(n) * sign)
    }

    /// The cycles of the measured periods.
    #[must_use]
    pub fn measured(&self) -> std::ops::Range<usize> {
        self.sequence.period()..(self.periods + 1) * self.sequence.period()
    }

    /// The cycles in which it rises, and falls.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
    pub fn fade(&self) -> usize {
        libm::ceil(FADE / self.cycle_time - 1e-9).larger(1.0) as usize
    }

    /// Its total duration [s].
    #[must_use]
    pub fn duration(&self) -> f64 {
        ((self.periods + 1) * self.sequence.period() + self.fade()) as f64 * self.cycle_time
    }

    /// The steps of the commanded velocity 2 A.
    #[must_use]
    pub fn step(&self) -> f64 {
        2.0 * self.amplitude
    }

    /// The length of the move from the start to the end of the fade, at the speed v: duration times v.
    #[must_use]
    pub fn path(&self, speed: f64) -> f64 {
        self.duration() * speed
    }

    /// The slowest move during the excitation, 2.5 A.
    #[must_use]
    pub fn least_speed(&self) -> f64 {
        LEAST_SPEED * self.amplitude
    }
}
