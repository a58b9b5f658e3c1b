//! What feedforward does to the position lag in a closed loop, and that `docs/pictures` shows it. The formulas here are derived
//! by hand from the transfer functions, not from the blocks.
//!
//! With `G(s) = 1 - g1 s + g2 s^2 - ...` from command to velocity, `U = Kv E + F s X`, `s X_actual = G U` and the feedforward
//! `F = 1 + Ta s + jf Ta^2 s^2`, the lag is `E = s X (1 - G F) / (s + Kv G)`. Constant velocity, acceleration and jerk leave
//!
//! ```text
//! without          v / Kv
//! VEL              a g1 / Kv
//! VEL ACC JERK     j (Ta^2 - g2 - jf Ta^2) / Kv     where g1 = Ta
//! ```

use axgen_tests::pictures;
use axgen_tests::simulation::{Bench, INCREMENT, KV, run};
use machine::seven_phases::{Move, seconds};
use machine::velocity_loop::Loop;
use std::path::Path;

/// Equivalent time constant of drive and hold Ta [s].
const TA: f64 = 4e-3;

/// The loops, with T2 = 0.6 Ta.
const LOOPS: [Loop; 3] = [Loop::DeadTime, Loop::Pt1, Loop::Pt2 { t2: 0.6 * TA }];

/// Jerk-limited, to 0.35 m/s. The lag settles at least as fast as e^(-Kv t): constant acceleration lasts 18 / Kv, after which
/// e^-18 of some 0.2 mm are left, 3 pm.
const MOVE: Move = Move { jerk: 5e6, change: 100_000, acceleration: 600_000, velocity: 1_000_000 };

/// Constant jerk of 100 m/s^3 for 18 / Kv.
const JERK: Move = Move { jerk: 100e6, change: 600_000, acceleration: 0, velocity: 0 };

/// How far rounding to increments can move the lag [um]: half an increment at the output of a controller with gain Kv, whose
/// loop does not overshoot at Kv Ta = 0.12. Doubled, for what has not settled and for the doubles' own rounding.
const ROUNDING: f64 = INCREMENT / KV;

/// Phases of a move.
const ACCELERATION: usize = 1;
const VELOCITY: usize = 3;
const DECELERATION: usize = 5;

#[test]
fn without_feedforward_the_lag_at_constant_velocity_is_v_through_kv() {
    for drive in LOOPS {
        assert_near(lag(&bench("", drive), VELOCITY), MOVE.largest_velocity() / KV, ROUNDING, drive);
    }
}

#[test]
fn weights_leave_their_part_of_v_through_kv() {
    let lines = "vorsteuerung = \"VEL\"\nvs_v_faktor = 9\nvs_v_nenner = 10";
    let weighted = Bench { percentage: 80, ..bench(lines, Loop::Pt1) };
    assert_near(lag(&weighted, VELOCITY), (1.0 - 0.9 * 0.8) * MOVE.largest_velocity() / KV, ROUNDING, Loop::Pt1);
}

#[test]
fn with_velocity_a_lag_is_left_in_the_acceleration_phases_only() {
    let peak = MOVE.largest_acceleration() * TA / KV;
    for drive in LOOPS {
        let bench = bench("vorsteuerung = \"VEL\"", drive);
        assert_near(lag(&bench, ACCELERATION), peak, ROUNDING, drive);
        assert_near(lag(&bench, VELOCITY), 0.0, ROUNDING, drive);
        assert_near(lag(&bench, DECELERATION), -peak, ROUNDING, drive);
        // 1 s after the move.
        let rest = run(&bench, &MOVE, MOVE.end(6) + 1_000_000_000).last().expect("cycles").lag;
        assert_near(rest, 0.0, ROUNDING, drive);
    }
}

#[test]
fn with_velocity_and_acceleration_none_is_left_at_constant_acceleration_either() {
    for drive in LOOPS {
        let bench = bench("vorsteuerung = \"VEL ACC\"\nvs_a_faktor = 4000", drive);
        for phase in [ACCELERATION, VELOCITY, DECELERATION] {
            assert_near(lag(&bench, phase), 0.0, ROUNDING, drive);
        }
    }
}

/// Who sets the parameter to the drive's own 4 ms at a cycle of 1 ms keeps the lag of 0.5 ms.
#[test]
fn half_a_cycle_of_hold_belongs_to_the_time_constant() {
    for drive in LOOPS {
        for (parameter, missing) in [(4000, 0.5e-3), (4500, 0.0)] {
            let lines = format!("vorsteuerung = \"VEL ACC\"\nvs_a_faktor = {parameter}");
            let bench = Bench { drive_ns: 4_000_000, ..bench(&lines, drive) };
            let left = MOVE.largest_acceleration() * missing / KV;
            assert_near(lag(&bench, ACCELERATION), left, ROUNDING, drive);
        }
    }
}

/// At 62.5 us the hold hardly matters.
#[test]
fn the_jerk_leaves_what_the_second_order_of_the_drive_leaves() {
    let [dead_time, pt1, pt2] = LOOPS;
    for (drive, percent, expected) in [
        (dead_time, 0, 26.666_666_667),
        (dead_time, 50, 0.0),
        (pt2, 0, 19.2),
        (pt2, 36, 0.0),
        (pt1, 0, 0.0),
        (pt1, 25, -13.333_333_333),
    ] {
        // The hold in series with a lag T adds T Ts/2 + Ts^2/12 to Ta^2 - g2, with a dead time at most Ts^2/12 (see below).
        let ts = seconds(62_500);
        let series = if drive == dead_time { 0.0 } else { TA * ts / 2.0 };
        let allowed = JERK.jerk * (series + ts * ts / 12.0) / KV + ROUNDING;
        assert_near(jerk_lag(62_500, drive, percent), expected, allowed, (drive, percent));
    }
}

/// The same with the hold in the formula: exp(-T s), 1 / (1 + T s) or 1 / (1 + T s + T2^2 s^2) with T = Ta - Ts/2, in series
/// with the hold's (1 - exp(-Ts s)) / (Ts s) = 1 - Ts s/2 + Ts^2 s^2/6 - ...
#[test]
fn the_jerk_leaves_what_the_second_order_of_drive_and_hold_leaves() {
    for cycle_ns in [62_500, 1_000_000] {
        let ts = seconds(u64::from(cycle_ns));
        let t = TA - ts / 2.0;
        for (drive, percent) in LOOPS.into_iter().flat_map(|drive| [0, 36, 50].map(|percent| (drive, percent))) {
            let of_drive = match drive {
                Loop::DeadTime => t * t / 2.0,
                Loop::Pt1 => t * t,
                Loop::Pt2 { t2 } => t * t - t2 * t2,
            };
            let g2 = of_drive + t * ts / 2.0 + ts * ts / 6.0;
            let expected = JERK.jerk * (TA * TA - g2 - f64::from(percent) / 100.0 * TA * TA) / KV;
            // The hold's sawtooth of a Ts, integrated, is a parabola in x_actual which the samples meet at a fixed place: at most
            // a Ts^2/12 from its mean, less after a lag. While the acceleration grows, that is a velocity of j Ts^2/12.
            let allowed = JERK.jerk * ts * ts / 12.0 / KV + ROUNDING;
            assert_near(jerk_lag(cycle_ns, drive, percent), expected, allowed, (cycle_ns, drive, percent));
        }
    }
}

#[test]
fn the_pictures_are_what_the_command_draws() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/pictures");
    let mut names = Vec::new();
    for (name, drawn) in pictures::all() {
        let kept = std::fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(kept == drawn, "{name} is not what this draws: {}", pictures::COMMAND);
        names.push(name.to_owned());
    }
    let entries = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    // The others are pictures of scenarios, which have their own test.
    let mut kept: Vec<String> = entries.filter(|name| name.starts_with("lag-")).collect();
    kept.sort_unstable();
    names.sort_unstable();
    assert_eq!(kept, names);
}

/// Cycle 1 ms, the drive and half a cycle of hold together Ta.
fn bench(feedforward: &str, drive: Loop) -> Bench<'_> {
    Bench { cycle_ns: 1_000_000, feedforward, percentage: 100, drive, drive_ns: 3_500_000 }
}

/// Lag at the end of a phase of [`MOVE`] [um].
fn lag(bench: &Bench<'_>, phase: usize) -> f64 {
    run(bench, &MOVE, MOVE.end(phase)).last().expect("cycles").lag
}

/// Lag at the end of a constant jerk with feedforward of everything, the factor of the jerk in percent [um].
fn jerk_lag(cycle_ns: u32, drive: Loop, percent: u32) -> f64 {
    let lines = format!(
        "vorsteuerung = \"VEL ACC JERK\"\nvs_a_faktor = 4000\njerk_fact_num = {percent}\njerk_fact_denom = 100"
    );
    let bench = Bench { cycle_ns, drive_ns: 4_000_000 - cycle_ns / 2, ..bench(&lines, drive) };
    run(&bench, &JERK, JERK.end(0)).last().expect("cycles").lag
}

fn assert_near(found: f64, expected: f64, allowed: f64, what: impl std::fmt::Debug) {
    assert!((found - expected).abs() <= allowed, "{what:?}: {found} um, not {expected} um within {allowed}");
}
