//! The watch over the loop (key `watch`) on random loops: unstable ones are faded out in time, stable ones never. Each real type.

use axgen_tests::environment::{by_depth, is_every_level};
use axgen_tests::random::rng::Rng;
use axgen_tests::two_mass::{Cause, Loop, Run, Stimulus, coefficients, growth, run};
use portable::{Real, RealKind};
use rayon::prelude::*;
use reference::ipc::Coeffs;

const SEED: u64 = 20_261_123;
/// Loops of each kind, of which one may trip that should not.
const LOOPS: usize = 100;
/// A swing grows, or decays, by e in less than so long [s]: what lies between is neither.
const GROWS: f64 = 1.0;
const DECAYS: f64 = -3.0;
/// |v_add| may be at its limit for so long in one spell before it is faded out [s]. What a move does before the loop
/// has grown counts for itself.
const ALLOWED: f64 = 0.2;
/// So many of 100 must be faded out in time.
const IN_TIME: usize = 95;
/// Runs of unstable and of stable loops [s], and how long after the trip [s].
const UNSTABLE: f64 = 30.0;
const STABLE: f64 = 12.0;
const AFTER: f64 = 1.0;

/// Random loops that are good without improved position control, by how they are with it: unstable ones, stable ones;
/// each with its growth.
fn loops(count: usize) -> [Vec<(Loop, f64, Rng)>; 2] {
    let mut found = [Vec::new(), Vec::new()];
    for first in (0..).step_by(4 * LOOPS) {
        let one = |index: usize| {
            let mut rng = Rng::numbered(SEED, index);
            let of = Loop::random(&mut rng);
            (growth(&of.bare()) < -0.5).then(|| (growth(&of), of, rng))
        };
        let drawn: Vec<_> = (first..first + 4 * LOOPS).into_par_iter().filter_map(one).collect();
        for (rate, of, rng) in drawn {
            let kind = match rate {
                _ if rate > GROWS => 0,
                _ if rate < DECAYS => 1,
                _ => continue,
            };
            if found[kind].len() < count {
                found[kind].push((of, rate, rng));
            }
        }
        if found.iter().all(|of| of.len() == count) {
            break;
        }
    }
    found
}

fn count() -> usize {
    LOOPS / 2 * by_depth(1, 1, 20)
}

fn watched<R: Real + Send + Sync>(all: &[(Loop, f64, Rng)], kind: RealKind, seconds: f64) -> Vec<Run>
where
    Coeffs<R>: Copy,
{
    let one = |(of, _, rng): &(Loop, f64, Rng)| {
        let mut stimulus = Stimulus::random(of, &mut rng.clone(), seconds);
        run::<R>(of, coefficients(of, kind, true), &mut stimulus, AFTER)
    };
    all.par_iter().map(one).collect()
}

/// Of sorted values.
fn at(values: &[f64], percent: usize) -> f64 {
    values[(values.len() - 1) * percent / 100]
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn unstable_loops_are_faded_out_and_stable_ones_are_not() {
    let [unstable, stable] = loops(count());
    let rates = sorted(unstable.iter().map(|(_, rate, _)| *rate));
    let causes = [Cause::Weight, Cause::Delay, Cause::Frequency, Cause::None]
        .map(|cause| (cause, unstable.iter().filter(|(of, ..)| of.cause == cause).count()));
    eprintln!("{} unstable loops, {causes:?}, growth {:.1} to {:.1} 1/s", rates.len(), at(&rates, 0), at(&rates, 100));
    for kind in [RealKind::F64, RealKind::F32] {
        let [runs, calm] = match kind {
            RealKind::F64 => [watched::<f64>(&unstable, kind, UNSTABLE), watched::<f64>(&stable, kind, STABLE)],
            RealKind::F32 => [watched::<f32>(&unstable, kind, UNSTABLE), watched::<f32>(&stable, kind, STABLE)],
        };
        let is_in_time = |run: &Run| run.faded_out.is_some() && run.spell < ALLOWED;
        let in_time = runs.iter().filter(|run| is_in_time(run)).count();
        let at_limit = sorted(runs.iter().map(|run| run.spell * 1e3));
        let all_in_all = runs.iter().filter(|run| run.faded_out.is_some() && run.at_limit < ALLOWED).count();
        let without = runs.iter().filter(|run| run.tripped.is_none()).count();
        let tripped = calm.iter().filter(|run| run.tripped.is_some()).count();
        let limited = calm.iter().filter(|run| run.at_limit > 0.0).count();
        eprintln!(
            "{kind:?}: of {} unstable loops {in_time} are faded out in time ({all_in_all}, all spells added up), {without} never; ms at the limit: median {:.0}, 95 % {:.0}, \
             largest {:.0}; of {} stable ones {tripped} trip, {limited} reach their limit",
            runs.len(),
            at(&at_limit, 50),
            at(&at_limit, 95),
            at(&at_limit, 100),
            calm.len()
        );
        for ((of, rate, _), run) in unstable.iter().zip(&runs).filter(|(_, run)| !is_in_time(run)) {
            eprintln!("  late: {:?} growth {rate:.1}, f0 {:.1?}, {run:.3?}", of.cause, of.frequencies());
        }
        for ((of, rate, _), run) in stable.iter().zip(&calm).filter(|(_, run)| run.tripped.is_some()) {
            eprintln!("  trips: {:?} growth {rate:.1}, f0 {:.1?}, {run:.3?}", of.cause, of.frequencies());
        }
        assert!(in_time * 100 >= IN_TIME * runs.len(), "{in_time}");
        assert!(tripped * LOOPS < calm.len(), "{tripped}");
        assert!(limited * 20 > calm.len() || !is_every_level(), "{limited}: no stable loop shows the limit");
    }
}

/// One by one what a stable loop must bear: a whole move, one with three times the acceleration, whose ramps reach the limit,
/// a force that comes at once, a burst of chatter that decays.
#[test]
fn what_decays_trips_no_stable_loop() {
    let [_, stable] = loops(LOOPS / by_depth(4, 4, 1));
    type Disturb = fn(&Loop, &mut Stimulus);
    let scenes: [(&str, Disturb); 4] = [
        ("move", |of, stimulus| stimulus.one_move(of, 0.5, 3.0)),
        ("hard move", |of, stimulus| {
            let mut fast = of.clone();
            fast.acceleration *= 3.0;
            stimulus.one_move(&fast, 0.5, 3.0);
        }),
        ("blow", |of, stimulus| stimulus.blow(of, 0.5, 1.0)),
        ("chatter", |of, stimulus| {
            let [lowest, _] = of.frequencies();
            stimulus.burst(of, stimulus.velocity.len() / 8, lowest, 3.0, 0.1);
        }),
    ];
    for (name, scene) in scenes {
        let one = |(of, rate, rng): &(Loop, f64, Rng)| {
            let mut stimulus = Stimulus::rest(of, rng, 4.0);
            scene(of, &mut stimulus);
            let shown = run::<f64>(of, coefficients(of, RealKind::F64, true), &mut stimulus, AFTER);
            (shown, *rate, of.frequencies())
        };
        let all: Vec<_> = stable.par_iter().map(one).collect();
        let limited = all.iter().filter(|(run, ..)| run.at_limit > 0.0).count();
        let tripped: Vec<_> = all.iter().filter(|(run, ..)| run.tripped.is_some()).collect();
        eprintln!(
            "{name}: of {} stable loops {limited} reach their limit, {} trip {tripped:.3?}",
            all.len(),
            tripped.len()
        );
        // A loop that is hardly damped, under three times the acceleration that its axis has, looks like an unstable one.
        assert!(tripped.len() <= usize::from(name == "hard move"), "{name}");
        assert!(limited > 0 || name == "blow", "{name}: no loop shows the limit");
    }
}
