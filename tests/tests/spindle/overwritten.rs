//! What overwrites the memory is shown, and the outputs stay within their ranges.

use super::bench::{Bench, RPM};
use super::every_state::{STATES, Way};
use reference::spindle::{Outputs, SpindleState, State};

fn assert_within(o: &Outputs<f64>) {
    assert!((0.0..360_000.0).contains(&o.x_spindle) && o.v_spindle.abs() <= 1e15, "{o:?}");
    assert!(o.job_speed.abs() <= 1e15 && o.job_position.abs() <= 7e14, "{o:?}");
    let known = [0, 1, 3, 14, 17, 18, 23, 31, 32, 33, 34, 35, 36, 41, 42, 43, 44, 45, 46, 47, 48, 49];
    assert!(known.contains(&o.error_id) && o.waiting <= 4, "{o:?}");
}

type Change = fn(&mut State<f64>, f64);

const REALS: [Change; 13] = [
    |s, x| s.x = x,
    |s, x| s.v = x,
    |s, x| s.x_start = x,
    |s, x| s.seen.v = x,
    |s, x| s.seen.v_last = x,
    |s, x| s.seen.v_before = x,
    |s, x| s.present.speed = x,
    |s, x| s.present.position = x,
    |s, x| s.request[0].speed = x,
    |s, x| s.request[0].position = x,
    |s, x| s.request[3].speed = x,
    |s, x| s.request[3].position = x,
    |s, x| (s.x, s.v) = (x, x),
];

/// Usual cycles, and all others.
fn states() -> Vec<Way> {
    let after_drive_off: Way = |bench| {
        let mut bench = bench.fast(1000.0 * RPM);
        bench.with_inputs(|i| i.drive_on = false);
        bench
    };
    STATES.into_iter().map(|(_, state)| state).chain([Bench::at_rest, after_drive_off]).collect()
}

#[test]
fn a_number_that_is_none_never_comes_out() {
    for state in states() {
        for bench in Bench::both() {
            for change in REALS {
                for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1.1e15] {
                    let mut bench = state(Bench::with(bench.coeffs));
                    change(&mut bench.state, x);
                    for cycle in 0..40 {
                        let ask = cycle == 20;
                        let o = bench.with_inputs(|i| i.m5 = ask);
                        assert_within(&o);
                    }
                }
            }
        }
    }
}

/// Each bit of each real, from each state.
#[test]
fn a_flipped_bit_never_leads_beyond_the_ranges() {
    let get: [fn(&State<f64>) -> f64; 8] = [
        |s| s.x,
        |s| s.v,
        |s| s.x_start,
        |s| s.seen.v,
        |s| s.seen.v_last,
        |s| s.seen.v_before,
        |s| s.present.speed,
        |s| s.present.position,
    ];
    for state in states() {
        for (change, of) in REALS.into_iter().zip(get) {
            for bit in 0..64 {
                let mut bench = state(Bench::in_drive());
                let flipped = f64::from_bits(of(&bench.state).to_bits() ^ 1 << bit);
                change(&mut bench.state, flipped);
                for _ in 0..10 {
                    let o = bench.cycle();
                    assert_within(&o);
                }
            }
        }
    }
}

#[test]
fn an_impossible_state_is_error_3_and_stops() {
    let changes: [fn(&mut State<f64>); 5] = [
        |s| s.present.speed = f64::NAN,
        |s| s.present.position = 1e300,
        |s| s.x = -1.0,
        |s| s.queued = 5,
        |s| s.lasting_error = 99,
    ];
    for change in changes {
        let mut bench = Bench::in_drive().fast(1000.0 * RPM);
        change(&mut bench.state);
        let o = bench.with_inputs(|i| i.m5 = true);
        assert_eq!((o.error_id, o.spindle_state), (3, SpindleState::Velocity));
        assert_eq!(bench.cycle().error_id, 3, "it stays");
        bench.with_inputs(|i| i.reset = true);
        let o = bench.until(SpindleState::Position);
        assert_eq!((o.error_id, o.waiting), (0, 0));
    }
}

/// Memory of zeros, which `init` has not prepared, is not POSITION, at rest or while the spindle turns.
#[test]
fn memory_of_zeros_is_error_3() {
    for mut bench in Bench::both() {
        bench.state =
            State { control: SpindleState::Position, control_copy: SpindleState::Position, ..State::default() };
        (bench.x_actual, bench.v_actual) = (Some(90_000.0), Some(1000.0 * RPM));
        let o = bench.with_inputs(|i| i.drive_on = true);
        assert_eq!((o.error_id, o.spindle_state, o.loop_closed), (3, SpindleState::ToPosition, false));
        assert_eq!(o.v_spindle, 1000.0 * RPM, "it is braked from the velocity that it has");
    }
}

/// A drive that is on, and no sample of the velocity since the start: the position command is where the spindle is.
#[test]
fn without_a_velocity_the_start_shows_the_actual_position() {
    for mut bench in Bench::both() {
        (bench.x_actual, bench.v_actual) = (Some(123_000.0), Some(f64::NAN));
        let o = bench.with_inputs(|i| i.drive_on = true);
        assert_eq!((o.x_spindle, o.v_spindle, o.error_id), (123_000.0, 0.0, 23));
    }
}

#[test]
fn an_error_that_may_not_stay_becomes_error_3() {
    for id in (0..200).chain([u32::MAX, 1 << 31]) {
        // 9 is for blocks that look at the rate of their calls, 18 and 48 for those that close the loop.
        let may_stay = [0, 1, 3, 14, 17, 41, 42, 43, 44, 45, 46].contains(&id);
        let mut bench = Bench::in_drive().turning();
        bench.state.lasting_error = id;
        assert_eq!(bench.cycle().error_id, if may_stay { id } else { 3 });
    }
}

/// What is known of a spindle that turns is forgotten with it: it is braked from the velocity that it has.
#[test]
fn an_overwritten_sample_is_none_of_the_velocity() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    (bench.x_actual, bench.v_actual) = (Some(90_000.0), Some(1000.0 * RPM));
    bench.inputs.drive_on = false;
    bench.cycles(5);
    bench.state.seen.v_last = f64::NAN;
    bench.inputs.drive_on = true;
    let o = bench.cycle();
    assert_eq!((o.error_id, o.v_spindle), (3, 1000.0 * RPM));
}
