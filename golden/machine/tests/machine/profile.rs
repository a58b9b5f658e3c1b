//! How a mover moves: each kind of motion by the numbers that its formula gives. No NC program.

#![expect(clippy::float_cmp, reason = "the end of a motion is exact")]

use machine::profile::{Error, Limits, Mover, Sample};

/// 0.001 deg: 1000 rpm, reached in about half a second.
const SPINDLE: Limits = Limits { velocity: 6e6, acceleration: 1.2e7, jerk: 1.2e8 };
/// mm: 30 m/min, 2 m/s^2
const AXIS: Limits = Limits { velocity: 500.0, acceleration: 2000.0, jerk: 50_000.0 };
const CYCLE: f64 = 0.001;

/// Samples to the end, with the one before the first.
pub fn run(mover: &mut Mover) -> Vec<Sample> {
    let mut samples = vec![mover.now()];
    while !mover.is_done() {
        samples.push(mover.next());
        assert!(samples.len() < 1_000_000, "no end: {mover:?}");
    }
    samples
}

/// Holds each sample and each step against the limits. An excess by a rounding of the library is not a mistake.
pub fn hold(samples: &[Sample], limits: Limits, cycle: f64) {
    let within = |what: &str, value: f64, most: f64, reached: f64| {
        assert!(value.abs() <= most * (1.0 + 1e-9) + reached.abs() * 1e-12, "{what}: {value} is above {most}");
    };
    for sample in samples {
        within("v", sample.v, limits.velocity, 0.0);
        within("a", sample.a, limits.acceleration, 0.0);
        within("j", sample.j, limits.jerk, 0.0);
    }
    for pair in samples.windows(2) {
        let [before, after] = pair else { unreachable!() };
        within("step of x", after.x - before.x, limits.velocity * cycle, after.x);
        within("step of v", after.v - before.v, limits.acceleration * cycle, limits.velocity);
        within("step of a", after.a - before.a, limits.jerk * cycle, limits.acceleration);
    }
}

fn at(limits: Limits, x: f64, v: f64) -> Mover {
    Mover::at(limits, CYCLE, x, v).expect("good numbers")
}

/// Time to change the speed by dv: dv / a + a / j.
fn time(limits: Limits, dv: f64) -> f64 {
    dv / limits.acceleration + limits.acceleration / limits.jerk
}

fn cycles(seconds: f64) -> f64 {
    (seconds / CYCLE).ceil()
}

#[test]
fn without_a_target_it_moves_on() {
    let mut mover = at(SPINDLE, 10.0, 6000.0);
    assert!(mover.is_done());
    assert_eq!(mover.next(), Sample { x: 16.0, v: 6000.0, a: 0.0, j: 0.0 });
    assert_eq!(mover.next(), Sample { x: 22.0, v: 6000.0, a: 0.0, j: 0.0 });
}

/// The end lies within a cycle: what is left of it is moved with the new speed.
#[test]
fn from_rest_to_a_speed() {
    let v = -5_876_543.0;
    let mut mover = at(SPINDLE, 0.0, 0.0);
    mover.turn(v).expect("a profile");
    let samples = run(&mut mover);
    hold(&samples, SPINDLE, CYCLE);
    let last = mover.now();
    assert_eq!((last.v, last.a, last.j), (v, 0.0, 0.0));
    let needed = time(SPINDLE, -v);
    let taken = samples.len() as f64 - 1.0;
    assert_eq!(taken, cycles(needed));
    // The change is symmetrical: half the speed, on average.
    let expected = v * (needed / 2.0 + (taken * CYCLE - needed));
    assert!((last.x - expected).abs() < 1e-9 * expected.abs(), "{} instead of {expected}", last.x);
    let next = mover.next();
    assert_eq!(next.v, v);
    assert!((next.x - last.x - v * CYCLE).abs() < 1e-6);
}

#[test]
fn from_a_speed_to_a_stop_and_to_the_other_direction() {
    let mut mover = at(SPINDLE, 0.0, 3e6);
    mover.turn(0.0).expect("a profile");
    let stop = run(&mut mover);
    hold(&stop, SPINDLE, CYCLE);
    assert_eq!(mover.now().v, 0.0);
    assert!((mover.now().x - 3e6 * time(SPINDLE, 3e6) / 2.0).abs() < 1e-2);
    let mut mover = at(SPINDLE, 0.0, 3e6);
    mover.turn(-3e6).expect("a profile");
    let reversal = run(&mut mover);
    hold(&reversal, SPINDLE, CYCLE);
    assert!(reversal.windows(2).all(|pair| pair[1].v <= pair[0].v), "the speed only falls");
    assert_eq!(mover.now().v, -3e6);
}

#[test]
fn from_rest_to_a_position() {
    for (target, v_max) in [(1000.0, 500.0), (-1000.0, 100.0), (0.01, 500.0), (1e-6, 500.0), (-3.0, 0.5)] {
        let mut mover = at(AXIS, 0.0, 0.0);
        mover.go(target, v_max).expect("a profile");
        let samples = run(&mut mover);
        hold(&samples, Limits { velocity: v_max, ..AXIS }, CYCLE);
        assert_eq!(mover.now(), Sample { x: target, ..Sample::default() });
        assert_eq!(mover.next(), mover.now(), "it stays there");
        let falls = samples.windows(2).any(|pair| (pair[1].x - pair[0].x) * target.signum() < -1e-9);
        assert!(!falls, "it goes there straight");
        if target == 1000.0 {
            let needed = target / v_max + time(AXIS, v_max);
            assert!((samples.len() as f64 - 1.0 - cycles(needed)).abs() <= 1.0, "{} samples", samples.len());
        }
    }
}

#[test]
fn to_where_it_is() {
    let mut mover = at(AXIS, 12.5, 0.0);
    mover.go(12.5, 1.0).expect("a profile");
    assert!(run(&mut mover).iter().all(|sample| *sample == Sample { x: 12.5, ..Sample::default() }));
}

/// As for M19: from a speed in one direction, on to a target ahead.
#[test]
fn from_a_speed_to_a_position_ahead() {
    let mut mover = at(SPINDLE, 350_000.0, 6e6);
    let braking = 6e6 * time(SPINDLE, 6e6) / 2.0;
    let target = 350_000.0 + braking + 180_000.0;
    mover.go(target, 6e6).expect("a profile");
    let samples = run(&mut mover);
    hold(&samples, SPINDLE, CYCLE);
    assert!(samples.iter().all(|sample| sample.v > -1e-3 && sample.x < target + 1e-3), "no way back");
    assert_eq!(mover.now(), Sample { x: target, ..Sample::default() });
}

/// M19 with a lower S word: it slows down first, and keeps the lower speed from there.
#[test]
fn from_above_the_speed_of_the_way() {
    let mut mover = at(SPINDLE, 0.0, 6e6);
    mover.go(20_000_000.0, 300_000.0).expect("a profile");
    let samples = run(&mut mover);
    hold(&samples, SPINDLE, CYCLE);
    let slow = samples.iter().position(|sample| sample.v <= 300_000.0 * (1.0 + 1e-9)).expect("it slows down");
    assert!((slow as f64 - cycles(time(SPINDLE, 5.7e6))).abs() <= 1.0, "as fast as it may: {slow} cycles");
    hold(&samples[slow..], Limits { velocity: 300_000.0, ..SPINDLE }, CYCLE);
    assert!(samples.iter().all(|sample| sample.v > -1e-3), "it does not turn back");
    assert_eq!(mover.now().x, 20_000_000.0);
}

/// Equal calls give equal bits.
#[test]
fn a_mover_is_deterministic() {
    let motion = || {
        let mut mover = at(SPINDLE, 1.0, -2e6);
        mover.go(123_456.7, 1e6).expect("a profile");
        run(&mut mover).into_iter().map(|sample| (sample.x.to_bits(), sample.v.to_bits())).collect::<Vec<_>>()
    };
    assert_eq!(motion(), motion());
}

#[test]
fn numbers_out_of_range() {
    let bad = |limits, cycle, x, v| Mover::at(limits, cycle, x, v).expect_err("a bad number").to_string();
    let with = |velocity, acceleration, jerk| Limits { velocity, acceleration, jerk };
    for (said, expected) in [
        (bad(with(0.0, 1.0, 1.0), 1.0, 0.0, 0.0), "the limit of the velocity is 0, which is out of its range"),
        (bad(with(1.0, -1.0, 1.0), 1.0, 0.0, 0.0), "the limit of the acceleration is -1, which is out of its range"),
        (bad(with(1.0, 1.0, f64::INFINITY), 1.0, 0.0, 0.0), "the limit of the jerk is inf, which is out of its range"),
        (bad(with(1.0, 1.0, 1.0), 0.0, 0.0, 0.0), "the cycle time is 0, which is out of its range"),
        (bad(with(1.0, 1.0, 1.0), 1.0, f64::NAN, 0.0), "the position is NaN, which is out of its range"),
        (bad(with(1.0, 1.0, 1.0), 1.0, 0.0, -1.5), "the velocity is -1.5, which is out of its range"),
    ] {
        assert_eq!(said, expected);
    }
    let mut mover = at(AXIS, 0.0, 10.0);
    let number = |name, value| Err(Error::Number { name, value });
    assert_eq!(mover.turn(500.5), number("the target velocity", 500.5));
    assert_eq!(mover.go(f64::INFINITY, 1.0), number("the target position", f64::INFINITY));
    assert_eq!(mover.go(1.0, 0.0), number("the velocity of the way", 0.0));
    assert_eq!(mover.go(1.0, 501.0), number("the velocity of the way", 501.0));
    assert_eq!(mover.next(), Sample { x: 0.01, v: 10.0, a: 0.0, j: 0.0 }, "the motion is as it was");
}

/// A way of hours, in steps of seconds.
#[test]
fn a_long_way() {
    let mut mover = Mover::at(AXIS, 10.0, 0.0, 0.0).expect("good numbers");
    mover.go(1000.0, 0.1).expect("a profile");
    let samples = run(&mut mover);
    hold(&samples, AXIS, 10.0);
    assert_eq!(samples.len(), 1002, "10,000 s and a little");
    assert_eq!(mover.now(), Sample { x: 1000.0, ..Sample::default() });
}

/// A target from a speed that still rises: what decides is the speed that is there when the acceleration is taken
/// back. Above the speed of the way it slows down to it, and keeps it.
#[test]
fn an_acceleration_counts_by_its_sign() {
    const SLOW: f64 = 300_000.0;
    for sign in [1.0, -1.0] {
        let mut rising = at(SPINDLE, 0.0, 0.0);
        rising.turn(6e6 * sign).expect("a profile");
        while rising.now().v * sign < SLOW - 20_000.0 {
            rising.next();
        }
        let Sample { v, a, .. } = rising.now();
        assert!(v.abs() < SLOW && (v + a * a.abs() / (2.0 * SPINDLE.jerk)).abs() > SLOW, "{v} {a}");
        rising.go(20_000_000.0 * sign, SLOW).expect("a profile");
        let samples = run(&mut rising);
        hold(&samples, SPINDLE, CYCLE);
        let top = samples.iter().position(|sample| sample.a * sign <= 0.0).expect("it takes the acceleration back");
        let braking =
            samples[top..].iter().position(|sample| sample.v * sign <= SLOW * (1.0 + 1e-9)).expect("it slows down");
        let slow = &samples[top + braking..];
        let kept = slow.iter().take_while(|sample| (sample.v.abs() - SLOW).abs() < 1e-6 * SLOW).count();
        assert!(kept > slow.len() / 2, "it keeps the speed: {kept} of {}", slow.len());
    }
}
