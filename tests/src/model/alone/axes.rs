//! Random axes for the block `ipc` that stands alone, and the parameter sets that fit each: other numbers of the same structure.

use super::block;
use super::set::{Set, Structure};
use crate::model::coefficients::Coefficients;
use crate::model::ipc::assert_sum_limit;
use crate::model::parameters::{Master, Mode, Parameters, Stage};
use crate::model::sections::Filters;
use crate::model::{random, subject};
use crate::random::rng::Rng;
use generator::blocks::Designed;

/// An axis with all that its block and its model are made of.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// its parameters
    pub parameters: Parameters,
    /// whether it is a gantry slave: the block must stay OFF
    pub is_slave: bool,
    /// what they mean
    pub coefficients: Coefficients,
    /// the block as it is designed
    pub designed: Designed,
    /// the largest sum of the block
    pub sum_limit: f64,
    /// the sets that fit
    pub structure: Structure,
    /// sets, the block's own first; empty where it takes none
    pub sets: Vec<Set>,
    /// the stages of the parameters that [`Set::of`] names
    pub filters: Vec<Vec<Filters>>,
}

/// Sets of an axis next to its own.
const OTHERS: usize = 3;

impl Drawn {
    /// A random one.
    ///
    /// # Panics
    /// If a set that `axgen` makes is not what its parameters say.
    #[must_use]
    pub fn new(rng: &mut Rng) -> Self {
        let parameters = parameters(rng);
        let takes_sets = parameters.tunable == "all";
        let variants: Vec<Parameters> =
            (0..if takes_sets { OTHERS } else { 0 }).map(|_| variant(&parameters, rng)).collect();
        let mut all = vec![parameters.clone()];
        all.extend(variants);
        // The fade is structure: as long as the longest period of all sets needs it.
        let fade_ns = all.iter().map(|p| p.fade_ns).max().expect("its own");
        all.iter_mut().for_each(|p| p.fade_ns = fade_ns);
        let mut parameters = all[0].clone();
        let is_slave = !takes_sets && rng.chance(10);
        // Nothing is watched there.
        parameters.watch &= !is_slave;
        let master = is_slave.then_some(Master { v_add_max_fact: 100, vb_max: 100_000, has_stage: false });
        let designed = subject::read(&Parameters { master, ..parameters.clone() }.set());
        let sum_limit = designed.ipc.sum_limit;
        let mut structure = Structure::new(&parameters, 0, 0.0);
        let mut sets = Vec::new();
        for (of, p) in all.iter().enumerate().filter(|_| takes_sets) {
            let set = block::set(&subject::read(&p.set()), &structure, of);
            if of == 0 {
                structure = Structure::new(&parameters, set.structure, set.numbers[0]);
            }
            is_what_its_parameters_say(p, &set, &structure);
            sets.push(set);
        }
        // A smaller limit, down to none, with a word that fits.
        if takes_sets {
            let mut set = sets[rng.below(sets.len())].clone();
            let limit = *rng.pick(&[0.0, set.numbers[0] / 2.0, set.numbers[0] / 64.0]);
            (set.numbers[0], set.numbers[1]) = (limit, -limit);
            sets.push(set.sealed(&structure));
        }
        let ts = f64::from(parameters.cycle_ns) * 1e-9;
        let filters = all.iter().map(|p| p.stages.iter().map(|stage| Filters::new(stage, ts)).collect()).collect();
        let coefficients = Coefficients::new(&parameters);
        Self { parameters, is_slave, coefficients, designed, sum_limit, structure, sets, filters }
    }
}

/// The limits of a set that `axgen` makes, and that it is taken over: its number, its word and its sections are right.
fn is_what_its_parameters_say(p: &Parameters, set: &Set, structure: &Structure) {
    let c = Coefficients::new(p);
    let ts = f64::from(p.cycle_ns) * 1e-9;
    let stages: Vec<Filters> = p.stages.iter().map(|stage| Filters::new(stage, ts)).collect();
    let [limit, sum_limit, quiet] = set.limits(structure);
    let is = |found: f64, expected: f64| (found - expected).abs() <= 4.0 * c.u * expected;
    assert!(is(limit, c.limit.near()), "limit {limit}, {p:#?}");
    assert_sum_limit(&stages, p, &c, sum_limit);
    assert!(!p.watch || is(quiet, limit / 50.0), "quiet {quiet}, {p:#?}");
    assert_eq!(set.refusal(structure), 0, "a set that axgen makes: {set:?}\n{structure:?}\n{}", p.set());
}

/// Stages, watch and ride-through more often than an axis has them, and limits that are reached.
fn parameters(rng: &mut Rng) -> Parameters {
    let mut p = random::parameters(rng);
    p.cycle_ns = *rng.pick(&[1_000_000, 2_000_000, 5_000_000]);
    // The interpolator plays no part: the block gets v_command itself.
    (p.kind, p.operation_mode, p.master, p.word) = (1, "CNC_POSITION_CONTROL", None, 0);
    p.single = rng.chance(30);
    p.tunable = *rng.pick(&["nothing", "weights", "all", "all", "all"]);
    p.watch = rng.chance(60);
    p.ride_through = *rng.pick(&[0, 0, 1, 2, 3]);
    p.v_add_max_fact = *rng.pick(&[5, 20, 100, 500]);
    p.vb_max = *rng.pick(&[100_000, 500_000]);
    p.stages = (0..rng.between(1, 3)).map(|_| stage(rng, p.cycle_ns)).collect();
    p.fade_ns = fade(&p, rng);
    p
}

/// Long enough for the lowest f0.
fn fade(p: &Parameters, rng: &mut Rng) -> u32 {
    let frequencies = |stage: &Stage| [Some(stage.band_pass.2), stage.all_pass.map(|(f0, _)| f0)];
    let lowest = p.stages.iter().flat_map(frequencies).flatten().fold(f64::INFINITY, f64::min);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most a second")]
    let period = (1e9 / lowest).ceil() as u32;
    period + u32::try_from(rng.below(20)).expect("small") * p.cycle_ns / 2
}

fn stage(rng: &mut Rng, cycle_ns: u32) -> Stage {
    let all_pass = rng.chance(25).then(|| (frequency(rng, cycle_ns), quality(rng)));
    Stage {
        mode: *rng.pick(&[Mode::DirectMotor, Mode::DirectLoad, Mode::Indirect, Mode::SetPoint]),
        weight: [u32::try_from(rng.between(1, 75)).expect("small"), 10],
        damping: damping(rng),
        band_pass: (
            rng.between(1, 3),
            *rng.pick(&["CRIT_DAMPING", "BUTTERWORTH", "BESSEL"]),
            frequency(rng, cycle_ns),
            quality(rng),
        ),
        all_pass,
        is_all_pass_first: rng.chance(40),
    }
}

/// From 20 Hz on, where the blocks of the watch last 30 ms, up to a quarter of the sampling frequency.
fn frequency(rng: &mut Rng, cycle_ns: u32) -> f64 {
    let highest = (0.25e9 / f64::from(cycle_ns)).min(200.0);
    let part = f64::from(u32::try_from(rng.below(1001)).expect("small")) / 1000.0;
    (20.0 * (highest / 20.0).powf(part) * 100.0).ceil() / 100.0
}

fn quality(rng: &mut Rng) -> f64 {
    f64::from(u32::try_from(rng.between(100, 800)).expect("small")) / 100.0
}

fn damping(rng: &mut Rng) -> f64 {
    f64::from(u32::try_from(rng.between(10, 99)).expect("small")) / 100.0
}

/// Other numbers of the same structure; the limit is at most the same.
fn variant(p: &Parameters, rng: &mut Rng) -> Parameters {
    let mut other = p.clone();
    for stage in &mut other.stages {
        stage.weight = [u32::try_from(rng.between(1, 75)).expect("small"), 10];
        stage.damping = damping(rng);
        (stage.band_pass.2, stage.band_pass.3) = (frequency(rng, p.cycle_ns), quality(rng));
        stage.all_pass = stage.all_pass.map(|_| (frequency(rng, p.cycle_ns), quality(rng)));
    }
    other.v_add_max_fact = u32::try_from(rng.between(1, p.v_add_max_fact as usize)).expect("small");
    other.fade_ns = fade(&other, rng);
    other
}
