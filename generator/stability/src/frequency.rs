//! Points of the frequency axis for the analysis of a loop: dense where the phase of a stage changes, sparse elsewhere. No
//! drive.

use crate::{Complex64, Drive, LARGEST_WEIGHT, STAGES, magnitude};
use portable::Extreme;
use std::f64::consts::PI;

/// The last point, as a part of the sampling frequency: t is still finite there.
const LAST: f64 = 0.499_99;
/// The first point, as a part of the lowest centre: far outside the band of every stage.
const FIRST: f64 = 1e-3;
/// Another point is inserted between two if the phase of a stage changes by more than this: sin^2 of 15 degrees.
const TURN: f64 = 0.067;
/// A stage whose contribution with the largest weight is smaller does not matter.
const SMALL: f64 = 0.1;
/// Halvings of an interval.
const DEPTH: u32 = 14;
/// Points per full turn of a delay.
const IN_A_TURN: f64 = 20.0;

/// The band of a stage [Hz]: centre, and distance of the -3 dB edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    pub centre: f64,
    pub width: f64,
}

/// A controller in the frequency domain.
pub struct Controller<'a> {
    /// T [s]
    pub cycle_time: f64,
    /// the weights of the stages; 0 for a stage that closes no loop
    pub weight: [f64; STAGES],
    /// the response of each stage with weight 1 from `v_motor` to its output at t = tan(pi f T), including its sign; with the
    /// input `v_command` the position controller is in it ([`position`])
    pub stage: Box<dyn Fn(f64) -> [Complex64; STAGES] + 'a>,
    /// the bands of the stages, which need points
    pub bands: Vec<Band>,
    /// gain of the position controller Kv [1/s], if its loop is closed around this one
    pub position_gain: Option<f64>,
    /// gain of the position controller Kv [1/s] in the drive: its loop is a part of P
    pub gain_in_drive: Option<f64>,
}

/// The position controller in the loop, Kv T/(z - 1), at t = tan(pi f T): 1/(z - 1) = (1 - j t)/(2 j t) = -1/2 - j/(2 t). The
/// output that it makes of `v_motor` has the opposite sign.
#[must_use]
pub fn position(gain_t: f64, t: f64) -> Complex64 {
    Complex64::new(-0.5, -0.5 / t) * gain_t
}

/// A controller at a frequency.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    /// tan(pi f T)
    pub t: f64,
    /// pi f T
    pub half: f64,
    /// each stage with weight 1
    pub stage: [Complex64; STAGES],
    /// the position controller: Kv T/(z - 1)
    pub position: Complex64,
}

impl Point {
    /// z^-1 = (1 - j t)/(1 + j t).
    pub(crate) fn delay(&self) -> Complex64 {
        let square = 1.0 + self.t * self.t;
        Complex64::new((1.0 - self.t * self.t) / square, -2.0 * self.t / square)
    }
}

/// The points of a controller, made once for all drives.
pub struct Points<'a> {
    pub(crate) controller: Controller<'a>,
    pub(crate) points: Vec<Point>,
}

impl<'a> Points<'a> {
    /// The points for these drives: as dense as the longest delay requires, and at the lines of measured responses.
    #[must_use]
    pub fn new(controller: Controller<'a>, drives: &[Drive<'_>]) -> Self {
        let cycle_time = controller.cycle_time;
        let warped = |frequency: f64| libm::tan(PI * frequency.smaller(LAST / cycle_time) * cycle_time);
        let delay_cycles = drives.iter().map(Drive::delay_cycles).fold(1.0, f64::larger);
        let mut frequencies: Vec<f64> = drives.iter().flat_map(Drive::lines).copied().collect();
        for Band { centre, width } in &controller.bands {
            for lowpass in [0.0, 0.5, 1.0, 2.0, 4.0, 8.0] {
                let half = lowpass * width / 2.0;
                let upper = half + (half * half + centre * centre).sqrt();
                frequencies.extend([upper, centre * centre / upper]);
            }
            frequencies.push(centre * FIRST);
        }
        if let Some(gain) = controller.position_gain.or(controller.gain_in_drive) {
            frequencies.extend([0.01, 0.1, 0.3, 1.0, 3.0, 10.0].map(|part| part * gain / (2.0 * PI)));
        }
        let steps = libm::ceil(IN_A_TURN * (delay_cycles + 1.0) / 2.0);
        let mut step = 1.0;
        while step <= steps {
            frequencies.push(LAST / cycle_time * step / steps);
            step += 1.0;
        }
        frequencies.retain(|frequency| *frequency > 0.0);
        frequencies.sort_by(f64::total_cmp);
        frequencies.dedup();
        let mut points: Vec<Point> = Vec::with_capacity(4 * frequencies.len());
        for frequency in frequencies {
            let next = controller.at(warped(frequency));
            match points.last().copied() {
                Some(last) if next.t <= last.t => continue,
                Some(last) => controller.between(last, next, DEPTH, &mut points),
                None => {}
            }
            points.push(next);
        }
        Self { controller, points }
    }
}

impl Controller<'_> {
    pub(crate) fn at(&self, t: f64) -> Point {
        let position = match self.position_gain {
            Some(gain) => position(gain * self.cycle_time, t),
            None => Complex64::new(0.0, 0.0),
        };
        Point { t, half: libm::atan(t), stage: (self.stage)(t), position }
    }

    /// The point in the middle of two, on a logarithmic axis.
    pub(crate) fn middle(&self, a: &Point, b: &Point) -> Point {
        self.at((a.t * b.t).sqrt())
    }

    /// The frequency [Hz] of pi f T.
    pub(crate) fn hz(&self, half: f64) -> f64 {
        half / (PI * self.cycle_time)
    }

    /// Inserts the necessary points between two points.
    fn between(&self, a: Point, b: Point, depth: u32, points: &mut Vec<Point>) {
        if depth == 0 || !(0..STAGES).any(|i| turns(a.stage[i], b.stage[i])) {
            return;
        }
        let middle = self.middle(&a, &b);
        self.between(a, middle, depth - 1, points);
        points.push(middle);
        self.between(middle, b, depth - 1, points);
    }
}

/// Whether the response of a stage changes much from a to b.
fn turns(a: Complex64, b: Complex64) -> bool {
    let (squares, larger) = (a.norm_sqr() * b.norm_sqr(), magnitude(a).larger(magnitude(b)));
    if larger * LARGEST_WEIGHT < SMALL {
        return false;
    }
    let product = a * b.conj();
    product.re < 0.0 || product.im * product.im > TURN * squares
}
