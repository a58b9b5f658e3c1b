//! The closed loop as a matrix: what is in its state after a cycle, for each unit of its state before. Its eigenvalues say whether it is stable,
//! exactly where the delay is whole.

use crate::random::{axis, read, stage};
use axgen_tests::environment::{by_depth, is_every_level};
use generator::analysis::{Known, analyze};
use generator::axis::DriveModel;
use generator::blocks::Designed;
use inside::rng::Rng;
use nalgebra::{Complex, DMatrix, Schur};
use reference::filter::Type;
use reference::stage::{Coeffs, Mode};
use std::f64::consts::PI;

/// b0, b1, b2, a1, a2 of a section.
type Section = [f64; 5];

/// A loop without anything of the product in it: the coefficients of the block, and the parts of the loop that no block knows.
struct Plain {
    /// sections of each stage, whose gain at weight 1 is -1, and whether it takes the output of the position controller
    stages: Vec<(Vec<Section>, bool)>,
    weights: Vec<f64>,
    delay: usize,
    /// e of the time constant; 0: none
    e: f64,
    /// Kv T
    position: f64,
    /// if the drive controls the position: position [s] and velocity after a cycle, each of both before it and of the command
    inside: Option<[[f64; 3]; 2]>,
}

/// The exponential of the differential equation of a drive with its position controller.
fn inside(kv: f64, cycle: f64, time_constant: Option<f64>) -> [[f64; 3]; 2] {
    let rate = 1.0 / time_constant.unwrap_or(1e-7);
    let equation = DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, -kv * rate, -rate, rate, 0.0, 0.0, 0.0]);
    let after = (equation * cycle).exp();
    [0, 1].map(|row| [0, 1, 2].map(|column| after[(row, column)]))
}

fn sections(of: &Coeffs<f64>) -> Vec<Section> {
    let mut all = Vec::new();
    if of.mode != Mode::Direct {
        let of = &of.oscillation;
        all.push([of.b0, of.b1, of.b2, of.a1, of.a2]);
    }
    for filter in &of.filter {
        match filter.kind {
            Type::NoFilter => {}
            Type::Bandpass => {
                all.extend(filter.bandpass.iter().take(filter.order).map(|of| [-of.b2, 0.0, of.b2, of.a1, of.a2]));
            }
            Type::Allpass => {
                all.push([filter.allpass.a2, filter.allpass.a1, 1.0, filter.allpass.a1, filter.allpass.a2])
            }
        }
    }
    all
}

impl Plain {
    fn new(designed: &Designed, delay: usize, time_constant: Option<f64>) -> Self {
        let cycle = designed.axis.cycle_time();
        let active: Vec<_> = designed.ipc.stage.iter().filter(|of| of.mode != Mode::NotActive).collect();
        // Where Kv is not given, SET_POINT is in a loop with its default.
        let is_inside = active.iter().any(|of| of.mode == Mode::SetPoint);
        let [gain, own] = designed.axis.control.placed(designed.axis.drive.position_gain.or(is_inside.then_some(10.0)));
        Self {
            weights: active.iter().map(|of| -of.gain).collect(),
            stages: active.iter().map(|of| (sections(of), of.mode == Mode::SetPoint)).collect(),
            delay,
            e: time_constant.map_or(0.0, |time| (-cycle / time).exp()),
            position: gain.map_or(0.0, |gain| gain * cycle),
            inside: own.map(|kv| inside(kv, cycle, time_constant)),
        }
    }

    /// A cycle: transposed direct form II, the sum, the delay line, the time constant, the sum of the position controller.
    fn cycle(&self, before: &[f64]) -> Vec<f64> {
        let mut after = before.to_vec();
        let line = before.len() - self.delay - 2;
        let [speed, position] = [line + self.delay, line + self.delay + 1];
        let u = before[line + self.delay - 1];
        let own = self.inside.map(|of| of.map(|[x, v, c]| x * before[position] + v * before[speed] + c * u));
        let v_motor = own.map_or(self.e * before[speed] + (1.0 - self.e) * u, |[_, v]| v);
        let v_command = self.position * before[position];
        let (mut v_cmd, mut at) = (v_command, 0);
        for ((sections, is_set_point), weight) in self.stages.iter().zip(&self.weights) {
            let mut x = if *is_set_point { v_command } else { v_motor };
            for [b0, b1, b2, a1, a2] in sections {
                let y = b0 * x + before[at];
                after[at] = b1 * x - a1 * y + before[at + 1];
                after[at + 1] = b2 * x - a2 * y;
                x = y;
                at += 2;
            }
            v_cmd -= weight * x;
        }
        after[speed] = v_motor;
        let sum = if self.position > 0.0 { before[position] - v_motor } else { 0.0 };
        after[position] = own.map_or(sum, |[x, _]| x);
        for place in (line + 1..line + self.delay).rev() {
            after[place] = before[place - 1];
        }
        after[line] = v_cmd;
        after
    }

    /// The largest magnitude of an eigenvalue.
    fn radius(&self) -> f64 {
        let n = self.stages.iter().map(|(sections, _)| 2 * sections.len()).sum::<usize>() + self.delay + 2;
        let columns: Vec<f64> = (0..n)
            .flat_map(|k| {
                let unit: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == k))).collect();
                self.cycle(&unit)
            })
            .collect();
        let matrix = DMatrix::from_vec(n, n, columns);
        // The search for eigenvalues need not end for a defective matrix, as a delay line alone is.
        match Schur::try_new(matrix.clone(), f64::EPSILON, 2000) {
            Some(schur) => {
                let values = schur.complex_eigenvalues();
                values.iter().map(|value| value.re.hypot(value.im)).fold(0.0, f64::max)
            }
            None => gelfand(matrix),
        }
    }

    /// 1 + L at a frequency, as a part of the sampling frequency.
    fn distance(&self, part: f64) -> f64 {
        let back = Complex::new(0.0, -2.0 * PI * part).exp();
        let delay = back.powu(u32::try_from(self.delay).expect("a small delay"));
        let one = Complex::new(1.0, 0.0);
        let drive = delay
            * self.inside.map_or((one - back * self.e).inv() * (1.0 - self.e), |[[xx, xv, x], [vx, vv, v]]| {
                (back * vx * x + (one - back * xx) * v)
                    / ((one - back * xx) * (one - back * vv) - back * back * xv * vx)
            });
        let position = back / (Complex::new(1.0, 0.0) - back) * self.position;
        let stages = self.stages.iter().zip(&self.weights).map(|((sections, is_set_point), weight)| {
            let each = sections.iter().map(|[b0, b1, b2, a1, a2]| {
                let [one, two] = [back, back * back];
                (one * *b1 + two * *b2 + b0) / (one * *a1 + two * *a2 + 1.0)
            });
            each.product::<Complex<f64>>() * if *is_set_point { position * *weight } else { Complex::from(-weight) }
        });
        let open = (position - stages.sum::<Complex<f64>>()) * drive;
        (open + 1.0).norm()
    }

    /// The largest |S|, over a grid, and over a finer one around its least distance.
    fn ms(&self, steps: u32, finer: i32) -> f64 {
        let at = |k: f64| self.distance(1e-4 * (0.5f64 / 1e-4).powf(k / f64::from(steps)));
        let least = (1..steps).map(|k| (at(f64::from(k)), k)).min_by(|a, b| a.0.total_cmp(&b.0));
        let (_, k) = least.expect("there are points");
        let around = (-finer..=finer).map(|n| at(f64::from(k) + f64::from(n) / 1000.0));
        1.0 / around.fold(f64::INFINITY, f64::min)
    }

    fn with(&self, stage: usize, weight: f64) -> Self {
        let mut weights = self.weights.clone();
        weights[stage] = weight;
        Self { stages: self.stages.clone(), weights, ..*self }
    }
}

/// The same as the limit of |A^n|^(1/n) (Gelfand), n = 2^40.
fn gelfand(mut matrix: DMatrix<f64>) -> f64 {
    let mut logarithm = 0.0;
    for k in 0..40 {
        let norm = matrix.norm();
        if norm == 0.0 {
            return 0.0;
        }
        logarithm += norm.ln() / 2.0f64.powi(k);
        matrix /= norm;
        matrix = &matrix * &matrix;
    }
    logarithm.exp()
}

/// A loop of a random axis, and the model of its drive.
fn random(rng: &mut Rng) -> (Designed, DriveModel, Plain) {
    let stages: Vec<String> = (0..rng.between(1, 3)).map(|_| stage(rng, 150.0)).collect();
    let word = if rng.chance(40) { "SET_POINT" } else { "INDIRECT" };
    let is_own = word == "INDIRECT" && rng.clone().chance(50); // a clone: the other axes stay what they were
    let keys = if rng.chance(50) { [", kv = 2000", ", kv = 20000"][usize::from(is_own)] } else { "" };
    let set = format!("cycle_time = \"1ms\"\n{}", axis("X", keys, "DRYRUN", &stages)).replace("INDIRECT", word);
    let own = "kenngr.antr_typ = 2\nprocess_data.additive_velocity = \"INT32\"\n";
    let set = set.replace("[axis.X]\n", &format!("[axis.X]\n{}", if is_own { own } else { "" }));
    let (axes, report) = read(&set);
    let designed = axes.unwrap_or_else(|| panic!("{report}\n{set}")).remove(0);
    let delay = rng.between(1, 5);
    let time_constant = rng.chance(50).then(|| 0.001 * (1.0 + rng.below(80) as f64 / 10.0));
    let plain = Plain::new(&designed, delay, time_constant);
    let model = DriveModel { delay_cycles: Some(delay as f64), time_constant, ..designed.axis.drive.clone() };
    (designed, model, plain)
}

/// An eigenvalue this near to the unit circle is neither stable nor unstable in 16 digits.
const UNDECIDED: f64 = 1e-7;

#[test]
fn turns_around_minus_one_are_eigenvalues_beyond_the_unit_circle() {
    let count = by_depth(300, 500, 10_000);
    let mut rng = Rng::new(0x5ab1);
    let (mut unstable, mut undecided) = (0, 0);
    for _ in 0..count {
        let (designed, model, plain) = random(&mut rng);
        let found = analyze(&designed, &model);
        let first = &found.drives[0];
        assert!(matches!(first.drive, Known::Delay { .. }));
        let radius = plain.radius();
        if (radius - 1.0).abs() < UNDECIDED {
            undecided += 1;
            continue;
        }
        unstable += u32::from(radius > 1.0);
        assert_eq!(first.margins.stable, radius < 1.0, "radius {radius}: {}", designed.axis.canonical);
    }
    println!("{count} loops, {unstable} unstable, {undecided} undecided");
    assert!(unstable > count / 10 && unstable < count - count / 10 && undecided < count / 100);
}

#[test]
fn the_largest_s_is_that_of_a_fine_grid() {
    let count = by_depth(60, 80, 500);
    let mut rng = Rng::new(0x0517);
    let (mut stable, mut worst) = (0, 0.0_f64);
    for _ in 0..count {
        let (designed, model, plain) = random(&mut rng);
        let Some([ms, _]) = analyze(&designed, &model).drives[0].margins.ms else { continue };
        stable += 1;
        let fine = plain.ms(40_000, 1000);
        worst = worst.max((ms / fine - 1.0).abs());
        assert!((ms / fine - 1.0).abs() < 0.01, "{ms} for {fine}: {}", designed.axis.canonical);
    }
    println!("{stable} stable loops, Ms differs by {worst:.1e} at most");
    assert!(stable > count / 5);
}

/// Steps of a weight in the search for the largest one, and how often the last one is halved.
const STEPS: u32 = 70;
const HALVINGS: u32 = 12;

/// The largest weight up to which something holds for all smaller ones.
fn largest(holds: impl Fn(f64) -> bool) -> f64 {
    let step = 7.0 / f64::from(STEPS);
    let Some(first) = (0..=STEPS).find(|k| !holds(f64::from(*k) * step)) else { return 7.0 };
    if first == 0 {
        return 0.0;
    }
    let (mut low, mut high) = (f64::from(first - 1) * step, f64::from(first) * step);
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if holds(middle) { low = middle } else { high = middle }
    }
    low
}

#[test]
fn the_largest_weights_are_those_of_eigenvalues_and_of_a_grid() {
    let count = by_depth(15, 20, 200);
    let mut rng = Rng::new(0x3a7e);
    let mut bounded = 0;
    for _ in 0..count {
        let (designed, model, plain) = random(&mut rng);
        let found = analyze(&designed, &model);
        for (n, of) in found.drives[0].stages.iter().enumerate() {
            let stable = largest(|weight| plain.with(n, weight).radius() < 1.0 + UNDECIDED);
            let text = || format!("stage {n}: {of:?}, {stable}: {}", designed.axis.canonical);
            // Between two steps of the search the loop may be unstable for a moment: then the search finds more.
            let is_right = |found: f64, searched: f64| {
                (found - searched).abs() <= 0.01 * searched.max(0.01)
                    || found < searched && plain.with(n, found * 1.003).radius() > 1.0
            };
            assert!(is_right(of.largest_stable_weight, stable), "{}", text());
            if stable > 0.0 && !is_every_level() || n == 0 {
                let calm = largest(|weight| weight <= stable && plain.with(n, weight).ms(4_000, 0) <= 2.0);
                assert!(
                    (of.largest_weight - calm).abs() <= 0.01 * calm.max(0.05) || stable <= 0.0,
                    "{calm}: {}",
                    text()
                );
            }
            bounded += u32::from(of.largest_stable_weight > 0.0 && of.largest_stable_weight < 7.0);
        }
    }
    println!("{count} loops, {bounded} weights that end");
    assert!(bounded > count / 3);
}
