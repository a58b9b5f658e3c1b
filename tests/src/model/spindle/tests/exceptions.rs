//! Drive off, reset, errors that stay, bad samples: sections 1 and 3 to 5 of a cycle, and the tests. No formula is here.

use super::bench::{Bench, Change, FAST};
use crate::model::spindle::{BRAKE, Inputs, POSITION, TO_POSITION, TO_VELOCITY, VELOCITY};

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

#[test]
fn with_the_drive_off_the_spindle_follows_it_and_starts_again() {
    let mut bench = Bench::drive().velocity();
    let number = bench.out.job_number;
    let out = bench.once(|i| (i.drive_on, i.x_actual, i.m19) = (false, -1000.0, true));
    assert_eq!((out.state, out.operation_mode, out.job, out.job_number), (TO_POSITION, 8, 0, number + 1));
    assert_eq!((out.waiting, out.fault, out.loop_closed), (1, false, false));
    assert!(same(out.x_spindle, 359_000.0) && same(out.v_spindle, 0.0));
    let out = bench.once(|i| (i.drive_on, i.x_actual) = (false, f64::NAN));
    assert_eq!((out.error_id, out.job_number), (18, number + 1));
    assert!(same(out.x_spindle, 359_000.0));
    // On again: error 18 and time as at first, then the request is served.
    bench.echoes = false;
    bench.inputs.operation_mode_display = 8;
    bench.inputs.x_actual = f64::INFINITY;
    assert_eq!(bench.cycles(20).error_id, 18);
    bench.inputs.x_actual = 77.0;
    let out = bench.cycle();
    assert_eq!((out.state, out.job, out.error_id), (TO_POSITION, 2, 0));
    assert!(same(out.x_spindle, 77.0));
}

#[test]
fn a_wrong_cycle_is_one_with_the_drive_off() {
    for (task_cycle_ns, error_id) in [(1_999_999, 1), (2_000_001, 1), (u32::MAX, 1), (0, 0), (2_000_000, 0)] {
        let mut bench = Bench::drive().positioned();
        let out = bench.once(|i| i.task_cycle_ns = task_cycle_ns);
        assert_eq!((out.error_id, out.state), (error_id, if error_id == 1 { TO_POSITION } else { POSITION }));
    }
}

#[test]
fn a_bad_start_waits_and_its_time_runs() {
    let mut bench = Bench::drive();
    bench.inputs.x_actual = 7.000_001e14;
    for _ in 0..20 {
        assert_eq!((bench.cycle().error_id, bench.out.state), (18, TO_POSITION));
    }
    assert_eq!(bench.cycle().error_id, 43);
}

#[test]
fn a_reset_ends_the_job_and_clears_what_waits() {
    let mut bench = Bench::drive().positioned();
    bench.once(|i| i.g74 = true);
    bench.once(|i| i.m3 = true);
    let out = bench.once(|i| i.reset = true);
    assert_eq!((out.state, out.job, out.job_number, out.waiting, out.error_id), (POSITION, 0, 2, 0, 0));
    assert_eq!(bench.once(|i| i.reset = true).job_number, 2);
}

#[test]
fn a_reset_leads_back_from_velocity_and_from_to_velocity_once_the_drive_answers() {
    let mut bench = Bench::drive().velocity();
    assert_eq!((bench.once(|i| i.reset = true).state, bench.out.job), (VELOCITY, 0));
    assert_eq!(bench.cycle().state, BRAKE);
    let mut bench = Bench::drive().changing();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    assert_eq!(bench.once(|i| i.reset = true).state, TO_VELOCITY);
    assert_eq!(bench.cycles(5).state, TO_VELOCITY);
    bench.inputs.operation_mode_display = 9;
    assert_eq!((bench.cycles(2).state, bench.cycle().state), (VELOCITY, BRAKE));
    // It remembers while the velocity is none.
    let mut bench = Bench::drive().velocity();
    bench.inputs.v_interpolator = f64::NAN;
    bench.once(|i| i.reset = true);
    assert_eq!((bench.cycles(9).state, bench.out.error_id), (VELOCITY, 14));
    bench.inputs.v_interpolator = 1.0;
    assert_eq!((bench.cycle().state, bench.cycle().state), (VELOCITY, BRAKE));
}

#[test]
fn the_return_is_forgotten_once_it_is_done() {
    let mut bench = Bench::drive().changing();
    bench.once(|i| i.reset = true);
    bench.inputs.v_actual = 0.0;
    let mut bench = bench.positioned();
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    bench.until(|out| out.state == VELOCITY);
    assert_eq!(bench.cycles(20).state, VELOCITY);
}

#[test]
fn an_error_that_stays_stops_the_spindle_and_serves_nothing_until_a_reset() {
    let mut bench = Bench::drive().velocity();
    let before = bench.out;
    let out = bench.once(|i| i.m5 = true);
    assert_eq!(out.job, 0);
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    let out = bench.cycle();
    assert_eq!((out.state, out.error_id, out.operation_mode, out.job), (VELOCITY, 45, 9, 0));
    assert_eq!(out.job_number, before.job_number + 3);
    assert!(
        same(out.v_spindle, FAST - 12_000.0) && same(out.x_spindle, (100_000.0 + 0.002 * out.v_spindle) % 360_000.0)
    );
    bench.inputs.operation_mode_display = 9;
    let out = bench.once(|i| i.g74 = true);
    assert_eq!((out.error_id, out.waiting, out.job), (45, 1, 0));
    assert_eq!(bench.until(|out| out.v_spindle <= 0.0), 148);
    bench.inputs.v_actual = 0.0;
    let out = bench.once(|i| i.reset = true);
    assert_eq!((out.state, out.error_id, out.waiting, out.operation_mode), (BRAKE, 0, 0, 9));
    assert_eq!((bench.cycles(2).state, bench.cycle().state), (BRAKE, TO_POSITION));
}

#[test]
fn an_error_that_stays_does_so_with_the_drive_off_and_a_reset_clears_it_there() {
    let mut bench = Bench::drive().velocity();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    bench.cycle();
    assert_eq!((bench.once(|i| i.drive_on = false).error_id, bench.out.state), (45, TO_POSITION));
    assert_eq!((bench.cycles(9).error_id, bench.out.state), (45, TO_POSITION));
    let out = bench.once(|i| (i.drive_on, i.reset) = (false, true));
    assert_eq!((out.error_id, out.state), (0, TO_POSITION));
    assert_eq!((bench.cycle().state, bench.cycle().state), (TO_POSITION, POSITION));
}

#[test]
fn position_control_with_another_mode_is_error_45() {
    let mut bench = Bench::drive().positioned();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 9);
    assert_eq!((bench.cycle().error_id, bench.out.state), (45, POSITION));
    let mut bench = Bench::cnc().positioned();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 9);
    assert_eq!(bench.cycle().error_id, 0);
}

#[test]
fn a_take_over_beyond_its_window_is_error_46() {
    for index in 0..2 {
        let after = |step: f64, bad: bool| {
            let mut bench = Bench::both().into_iter().nth(index).expect("two");
            bench.cycle();
            if bad {
                assert_eq!(bench.once(|i| i.x_command = f64::NAN).error_id, 17);
            }
            bench.inputs.x_command = 100_000.0 + step;
            let first = bench.cycle();
            assert_eq!(first.state, POSITION);
            bench.inputs.x_command += 5000.0;
            (first.error_id, bench.cycle().error_id)
        };
        assert_eq!([after(1000.0, false), after(-1000.0, false)], [(0, 0); 2]);
        assert_eq!([after(1001.0, false), after(-1001.0, false), after(180_000.0, false)], [(46, 46); 3]);
        assert_eq!([after(360_000.0, false), after(-719_500.0, false)], [(0, 0); 2]);
        // It stays due while there is no sample.
        assert_eq!([after(1001.0, true), after(999.0, true)], [(46, 46), (0, 0)]);
    }
}

#[test]
fn a_bad_sample_lets_the_spindle_go_on_for_a_cycle() {
    let bad: [(Change<Inputs>, u32); 4] = [
        (|i| i.v_interpolator = f64::NAN, 14),
        (|i| i.x_command = f64::NEG_INFINITY, 17),
        (|i| i.x_command = 7.000_001e14, 17),
        (|i| (i.x_command, i.v_interpolator) = (f64::NAN, 1.000_000_1e15), 14),
    ];
    for (change, id) in bad {
        let mut bench = Bench::drive().changing();
        (bench.echoes, bench.inputs.operation_mode_display) = (false, 9);
        let x = bench.out.x_spindle;
        let out = bench.once(change);
        assert_eq!((out.state, out.error_id, out.job), (TO_VELOCITY, id, 1));
        assert!(same(out.v_spindle, FAST) && same(out.x_spindle, x + FAST * 0.002));
        assert_eq!((bench.cycle().state, bench.out.error_id), (TO_VELOCITY, 0));
        assert_eq!(bench.cycle().state, VELOCITY);
        let mut bench = Bench::drive().positioned();
        let out = bench.once(|i| {
            change(i);
            i.m5 = true;
        });
        assert_eq!((out.state, out.error_id, out.loop_closed), (POSITION, id, false));
        assert_eq!((out.waiting, out.job_number), (0, 1), "served all the same");
    }
    let mut bench = Bench::drive().velocity();
    assert_eq!(bench.once(|i| i.v_interpolator = f64::NAN).error_id, 14);
    assert_eq!((bench.once(|i| i.v_actual = f64::NAN).error_id, bench.out.state), (0, VELOCITY));
}

#[test]
fn brake_brakes_on_with_bad_samples_and_waits_for_good_ones() {
    let mut bench = Bench::drive().brake();
    bench.inputs.v_actual = 0.0;
    bench.cycles(2);
    let v = bench.out.v_spindle;
    let out = bench.once(|i| i.v_actual = f64::NAN);
    assert_eq!((out.state, out.error_id), (BRAKE, 23));
    assert!(same(out.v_spindle, v - 12_000.0), "{out:?}");
    // An actual position is read in the third cycle only, and the count stays.
    assert_eq!(bench.once(|i| i.x_actual = f64::NAN).error_id, 0);
    bench.cycle();
    assert_eq!((bench.once(|i| i.x_actual = f64::NAN).error_id, bench.out.state), (18, BRAKE));
    assert_eq!((bench.cycle().state, bench.cycle().state), (BRAKE, TO_POSITION));
}

#[test]
fn what_is_told_first() {
    let mut bench = Bench::drive().positioned();
    let out = bench.once(|i| (i.task_cycle_ns, i.g74, i.m5, i.x_actual) = (1, true, true, f64::NAN));
    assert_eq!(out.error_id, 1);
    let mut bench = Bench::drive().positioned();
    let out = bench.once(|i| (i.g74, i.m5, i.v_interpolator) = (true, true, f64::NAN));
    assert_eq!((out.error_id, out.loop_closed), (31, false));
    let mut bench = Bench::drive().positioned();
    let out = bench.once(|i| (i.g74, i.m5, i.v_interpolator) = (true, true, 1e9));
    assert_eq!(out.error_id, 44);
    assert_eq!(bench.once(|i| (i.m3, i.m4) = (true, true)).error_id, 44);
}

#[test]
fn of_the_tests_the_first_is_told() {
    let first = |v, display, x| {
        let mut bench = Bench::drive();
        bench.cycles(1);
        bench.echoes = false;
        let out = bench.once(|i| (i.v_interpolator, i.operation_mode_display, i.x_command) = (v, display, x));
        (out.state, out.error_id)
    };
    assert_eq!(first(9e7, 9, 0.0), (POSITION, 44));
    assert_eq!(first(0.0, 9, 0.0), (POSITION, 45));
    assert_eq!(first(0.0, 8, 0.0), (POSITION, 46));
    assert_eq!(first(0.0, 8, 100_000.0), (POSITION, 0));
}

#[test]
fn brake_after_an_error_of_position_control_keeps_its_mode() {
    let mut bench = Bench::drive().positioned();
    assert_eq!(bench.once(|i| i.v_interpolator = 9e7).error_id, 44);
    let out = bench.once(|i| i.reset = true);
    assert_eq!((out.state, out.operation_mode, out.error_id), (BRAKE, 8, 0));
}

#[test]
fn the_mode_goes_out_with_a_bad_sample_too() {
    let mut bench = Bench::drive().positioned();
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    bench.cycle();
    let out = bench.once(|i| i.x_command = f64::NAN);
    assert_eq!((out.state, out.operation_mode, out.error_id), (TO_VELOCITY, 9, 17));
}

#[test]
fn a_position_of_brake_is_forgotten_with_the_drive_off() {
    let mut bench = Bench::drive().brake();
    bench.inputs.v_actual = 0.0;
    bench.cycles(3);
    assert_eq!(bench.once(|i| i.drive_on = false).state, TO_POSITION);
    bench.inputs.x_actual = 7.0;
    assert!(same(bench.cycle().x_spindle, 7.0), "{:?}", bench.out);
}
