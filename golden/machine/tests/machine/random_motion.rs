//! Motions with random limits, targets and changes of mind: no limit is broken, every end is reached. No NC program.

#![expect(clippy::float_cmp, reason = "the end of a motion is exact")]

use crate::profile::{hold, run};
use machine::profile::{Limits, Mover, Sample};
use proptest::prelude::*;

/// A number, every order of magnitude as probable as another.
fn magnitude(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from.log10()..to.log10()).prop_map(|exponent| 10f64.powf(exponent))
}

/// Limits by their times: a speed, the time to reach it, the time to reach the acceleration.
fn limits() -> impl Strategy<Value = Limits> {
    (magnitude(1e-2, 1e8), magnitude(1e-2, 10.0), magnitude(1e-3, 1.0)).prop_map(|(velocity, rise, start)| {
        let acceleration = velocity / rise;
        Limits { velocity, acceleration, jerk: acceleration / start }
    })
}

/// A target, relative to the limits, and the cycles until the next one counts.
#[derive(Clone, Debug)]
enum Target {
    Turn(f64),
    Go(f64, f64),
}

fn target() -> impl Strategy<Value = (Target, usize)> {
    let relative = || prop_oneof![8 => -1.0..1.0, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(-1.0)];
    let turn = relative().prop_map(Target::Turn);
    let way = prop_oneof![6 => -10.0..10.0, 2 => -1e-3..1e-3, 1 => Just(0.0)];
    let go = (way, prop_oneof![magnitude(0.1, 1.0), Just(1.0)]).prop_map(|(x, v)| Target::Go(x, v));
    (prop_oneof![turn, go], 1usize..300)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(3000) })]

    #[test]
    fn any_motion(
        limits in limits(),
        cycle in magnitude(5e-4, 1e-2),
        start in (-10.0..10.0, -1.0..1.0),
        targets in proptest::collection::vec(target(), 1..6),
    ) {
        let v = limits.velocity;
        let mut mover = Mover::at(limits, cycle, start.0 * v, start.1 * v).expect("good numbers");
        let mut samples = vec![mover.now()];
        let mut end = mover.now();
        for (target, cycles) in targets {
            end = match target {
                Target::Turn(to) => {
                    mover.turn(to * v).expect("a profile");
                    Sample { v: to * v, ..Sample::default() }
                }
                Target::Go(to, v_max) => {
                    mover.go(to * v, v_max * v).expect("a profile");
                    Sample { x: to * v, ..Sample::default() }
                }
            };
            samples.extend((0..cycles).map(|_| mover.next()));
        }
        samples.extend(run(&mut mover).into_iter().skip(1));
        hold(&samples, limits, cycle);
        let last = mover.now();
        prop_assert_eq!((last.v.to_bits(), last.a, last.j), (end.v.to_bits(), 0.0, 0.0));
        prop_assert!(end.v != 0.0 || end.x == 0.0 || last.x == end.x);
    }
}
