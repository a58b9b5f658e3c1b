//! Drive off, reset, errors that stay, bad samples: sections 2 to 5 and 8 of a cycle, and the tests. No formula is here.

use super::bench::{Bench, Change, FAST};
use crate::model::spindle::{BRAKE, Inputs, POSITION, TO_POSITION, TO_VELOCITY, VELOCITY};

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

#[test]
fn with_the_drive_off_the_spindle_follows_it_and_starts_again() {
    let mut bench = Bench::drive().changing();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    assert_eq!(bench.once(|i| i.g74 = true).waiting, 1);
    let number = bench.out.job_number;
    let out = bench.once(|i| (i.drive_on, i.x_actual) = (false, -1000.0));
    assert_eq!((out.spindle_state, out.operation_mode, out.job, out.job_number), (TO_POSITION, 8, 0, number + 1));
    assert_eq!((out.waiting, out.fault, out.loop_closed), (0, false, false));
    assert!(same(out.x_spindle, 359_000.0) && same(out.v_spindle, 0.0));
    let out = bench.once(|i| (i.drive_on, i.x_actual, i.m19) = (false, f64::NAN, true));
    assert_eq!((out.error_id, out.job_number, out.waiting), (18, number + 1, 0));
    assert!(same(out.x_spindle, 359_000.0));
    assert_eq!(bench.once(|i| (i.drive_on, i.m3) = (false, true)).error_id, 36);
    // On again: error 18 and time as at first.
    bench.inputs.x_actual = f64::INFINITY;
    assert_eq!(bench.cycles(20).error_id, 18);
    bench.inputs.x_actual = 77.0;
    let out = bench.once(|i| i.m19 = true);
    assert_eq!((out.spindle_state, out.job, out.error_id), (TO_POSITION, 2, 0));
    assert!(same(out.x_spindle, 77.0));
}

#[test]
fn a_wrong_cycle_is_an_error_that_stays() {
    for (task_cycle_ns, error_id) in [(1_999_999, 1), (2_000_001, 1), (u32::MAX, 1), (0, 0), (2_000_000, 0)] {
        let mut bench = Bench::drive().positioned();
        let out = bench.once(|i| i.task_cycle_ns = task_cycle_ns);
        assert_eq!((out.error_id, out.spindle_state, out.loop_closed), (error_id, POSITION, error_id == 0));
        assert_eq!(bench.cycles(9).error_id, error_id);
    }
    let mut bench = Bench::drive().velocity();
    let out = bench.once(|i| i.task_cycle_ns = 1);
    assert_eq!((out.spindle_state, out.error_id, out.operation_mode, out.job), (VELOCITY, 1, 9, 0));
    assert!(same(out.v_spindle, FAST - 12_000.0), "{out:?}");
    // Again in the cycle of the reset.
    for _ in 0..5 {
        let out = bench.once(|i| (i.task_cycle_ns, i.reset) = (1, true));
        assert_eq!((out.spindle_state, out.error_id), (BRAKE, 1));
    }
    assert_eq!((bench.once(|i| i.reset = true).error_id, bench.out.spindle_state), (0, BRAKE));
    // With the drive off too.
    let mut bench = Bench::drive().positioned();
    let out = bench.once(|i| (i.task_cycle_ns, i.drive_on, i.x_actual) = (1, false, f64::NAN));
    assert_eq!((out.error_id, out.spindle_state), (1, TO_POSITION));
    assert_eq!((bench.cycles(9).error_id, bench.out.spindle_state), (1, TO_POSITION));
}

#[test]
fn a_wrong_cycle_asks_for_no_mode() {
    let mut bench = Bench::drive();
    bench.inputs.task_cycle_ns = 1;
    assert_eq!((bench.cycle().operation_mode, bench.out.error_id), (8, 1));
    let mut bench = Bench::drive().positioned();
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    bench.cycle();
    let out = bench.once(|i| i.task_cycle_ns = 1);
    assert_eq!((out.spindle_state, out.operation_mode, out.error_id), (TO_VELOCITY, 8, 1));
}

#[test]
fn an_error_that_stays_is_not_replaced() {
    let mut bench = Bench::drive().positioned();
    assert_eq!(bench.once(|i| i.v_interpolator = 9e7).error_id, 44);
    assert_eq!(bench.once(|i| i.task_cycle_ns = 1).error_id, 44);
    assert_eq!(bench.once(|i| i.v_interpolator = f64::NAN).error_id, 44);
    assert_eq!(bench.once(|i| i.m19 = true).error_id, 44);
}

#[test]
fn a_bad_start_waits_and_its_time_runs() {
    let mut bench = Bench::drive();
    bench.inputs.x_actual = 7.000_001e14;
    for _ in 0..22 {
        assert_eq!((bench.cycle().error_id, bench.out.spindle_state), (18, TO_POSITION));
    }
    assert_eq!(bench.cycle().error_id, 43);
}

#[test]
fn a_reset_ends_the_job_and_clears_what_waits() {
    let mut bench = Bench::drive().positioned();
    bench.once(|i| i.g74 = true);
    bench.once(|i| i.m3 = true);
    let out = bench.once(|i| i.reset = true);
    assert_eq!((out.spindle_state, out.job, out.job_number, out.waiting, out.error_id), (POSITION, 0, 2, 0, 0));
    assert_eq!(bench.once(|i| i.reset = true).job_number, 2);
}

#[test]
fn a_reset_leads_back_from_velocity_and_from_to_velocity_once_the_drive_answers() {
    let mut bench = Bench::drive().velocity();
    assert_eq!((bench.once(|i| i.reset = true).spindle_state, bench.out.job), (VELOCITY, 0));
    assert_eq!(bench.cycle().spindle_state, BRAKE);
    let mut bench = Bench::drive().changing();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    assert_eq!(bench.once(|i| i.reset = true).spindle_state, TO_VELOCITY);
    assert_eq!(bench.cycles(5).spindle_state, TO_VELOCITY);
    bench.inputs.operation_mode_display = 9;
    assert_eq!((bench.cycles(2).spindle_state, bench.cycle().spindle_state), (VELOCITY, BRAKE));
    // It remembers while the velocity is none.
    let mut bench = Bench::drive().velocity();
    bench.inputs.v_interpolator = f64::NAN;
    bench.once(|i| i.reset = true);
    assert_eq!((bench.cycles(2).spindle_state, bench.out.error_id), (VELOCITY, 14));
    bench.inputs.v_interpolator = 1.0;
    assert_eq!((bench.cycle().spindle_state, bench.cycle().spindle_state), (VELOCITY, BRAKE));
}

#[test]
fn the_return_is_forgotten_once_it_is_done() {
    let mut bench = Bench::drive().changing();
    bench.once(|i| i.reset = true);
    bench.inputs.v_actual = 0.0;
    let mut bench = bench.positioned();
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    bench.until(|out| out.spindle_state == VELOCITY);
    assert_eq!(bench.cycles(20).spindle_state, VELOCITY);
}

#[test]
fn an_error_that_stays_stops_the_spindle_and_serves_nothing_until_a_reset() {
    let mut bench = Bench::drive().velocity();
    let before = bench.out;
    let out = bench.once(|i| i.m5 = true);
    assert_eq!(out.job, 0);
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    assert_eq!((bench.cycles(3).error_id, bench.out.job), (45, 1));
    let x = bench.out.x_spindle;
    let out = bench.cycle();
    assert_eq!((out.spindle_state, out.error_id, out.operation_mode, out.job), (VELOCITY, 45, 9, 0));
    assert_eq!(out.job_number, before.job_number + 3);
    assert!(same(out.v_spindle, FAST - 12_000.0) && same(out.x_spindle, (x + 0.002 * out.v_spindle) % 360_000.0));
    bench.inputs.operation_mode_display = 9;
    let out = bench.once(|i| i.g74 = true);
    assert_eq!((out.error_id, out.waiting, out.job), (45, 1, 0));
    assert_eq!(bench.until(|out| out.v_spindle <= 0.0), 148);
    bench.inputs.v_actual = 0.0;
    let out = bench.once(|i| i.reset = true);
    assert_eq!((out.spindle_state, out.error_id, out.waiting, out.operation_mode), (BRAKE, 0, 0, 9));
    assert_eq!((bench.cycles(2).spindle_state, bench.cycle().spindle_state), (BRAKE, TO_POSITION));
}

#[test]
fn an_error_that_stays_does_so_with_the_drive_off_and_a_reset_clears_it_there() {
    let mut bench = Bench::drive().velocity();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    bench.cycles(4);
    bench.inputs.v_actual = 0.0;
    let out = bench.once(|i| (i.drive_on, i.x_actual) = (false, 5.0));
    assert_eq!((out.error_id, out.spindle_state, out.operation_mode), (45, TO_POSITION, 8));
    assert!(same(out.x_spindle, 5.0) && same(out.v_spindle, 0.0));
    bench.inputs.x_actual = 5.0;
    assert_eq!((bench.cycles(9).error_id, bench.out.spindle_state), (45, TO_POSITION));
    assert!(same(bench.out.x_spindle, 5.0));
    let out = bench.once(|i| (i.drive_on, i.reset) = (false, true));
    assert_eq!((out.error_id, out.spindle_state), (0, TO_POSITION));
    assert_eq!((bench.cycles(2).spindle_state, bench.cycle().spindle_state), (TO_POSITION, POSITION));
}

#[test]
fn a_display_of_another_mode_is_a_missing_sample() {
    let mut bench = Bench::drive().positioned();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 9);
    let told: Vec<(u32, bool)> = (0..3).map(|_| (bench.cycle().error_id, bench.out.loop_closed)).collect();
    assert_eq!(told, [(45, false); 3]);
    bench.inputs.operation_mode_display = 8;
    assert_eq!((bench.cycle().error_id, bench.out.loop_closed), (0, true));
    let mut bench = Bench::drive().positioned();
    let out = bench.once(|i| (i.v_interpolator, i.x_command) = (-500.0, 1000.0));
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 9);
    let next = bench.cycle();
    assert!(same(next.v_spindle, -500.0) && same(next.x_spindle, out.x_spindle - 1.0), "{next:?}");
    let mut bench = Bench::drive().velocity();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    let x = bench.out.x_spindle;
    let out = bench.once(|i| i.v_interpolator = 5.0);
    assert_eq!((out.error_id, out.spindle_state), (45, VELOCITY));
    assert!(same(out.v_spindle, FAST) && same(out.x_spindle, x + FAST * 0.002));
    assert_eq!(bench.once(|i| i.v_interpolator = f64::NAN).error_id, 14);
    for mut bench in [Bench::cnc().positioned(), Bench::cnc().velocity()] {
        (bench.echoes, bench.inputs.operation_mode_display) = (false, 77);
        assert_eq!(bench.cycles(9).error_id, 0);
    }
}

#[test]
fn three_cycles_in_a_row_may_miss_a_sample_and_the_fourth_one_stays() {
    let x_command: Change<Inputs> = |i| i.x_command = f64::NAN;
    let v_interpolator: Change<Inputs> = |i| i.v_interpolator = f64::NAN;
    let display: Change<Inputs> = |i| i.operation_mode_display = -5;
    for (mut bench, changes, id) in [
        (Bench::drive().positioned(), [v_interpolator; 4], 14),
        (Bench::drive().positioned(), [x_command; 4], 17),
        (Bench::cnc().positioned(), [x_command; 4], 17),
        (Bench::drive().positioned(), [display; 4], 45),
        (Bench::drive().positioned(), [x_command, v_interpolator, display, x_command], 17),
        (Bench::drive().velocity(), [display, v_interpolator, v_interpolator, display], 45),
        (Bench::drive().changing(), [x_command, v_interpolator, x_command, v_interpolator], 14),
    ] {
        bench.echoes = false;
        let state = bench.out.spindle_state;
        let coast = |bench: &mut Bench| {
            let before = bench.out;
            for change in &changes[..3] {
                let out = bench.once(change);
                assert_eq!((out.spindle_state, out.fault, out.loop_closed), (state, true, false));
                assert!(same(out.v_spindle, before.v_spindle));
            }
            let moved = 3.0 * before.v_spindle * 0.002;
            assert!(same(bench.out.x_spindle, (before.x_spindle + moved) % 360_000.0), "{before:?}");
        };
        coast(&mut bench);
        if state != TO_VELOCITY {
            // One that misses none, and it begins again.
            let v = if state == POSITION { 1000.0 } else { FAST };
            let x = bench.out.x_spindle + bench.out.v_spindle * 0.002;
            let out = bench.once(|i| (i.x_command, i.v_interpolator) = (x, v));
            assert_eq!((out.spindle_state, out.error_id), (state, 0));
            coast(&mut bench);
        }
        let v = bench.out.v_spindle;
        let out = bench.once(changes[3]);
        assert_eq!((out.spindle_state, out.error_id, out.job), (state, id, 0));
        assert!(same(out.v_spindle, (v - 12_000.0).max(0.0)), "{out:?}");
        assert_eq!(bench.cycles(5).error_id, id);
    }
}

#[test]
fn the_time_of_to_velocity_runs_without_samples_and_its_error_waits_for_them() {
    let mut bench = Bench::drive().changing();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    assert_eq!(bench.cycles(18).error_id, 0);
    assert_eq!(bench.once(|i| i.x_command = f64::NAN).error_id, 17);
    assert_eq!(bench.once(|i| i.v_interpolator = f64::NAN).error_id, 14);
    bench.inputs.x_command = bench.out.x_spindle + bench.out.v_spindle * 0.002;
    let mut turns = Bench { model: bench.model.clone(), p: bench.p.clone(), ..bench };
    assert_eq!(turns.once(|i| i.v_interpolator = 9e7).error_id, 44, "before 41");
    let mut answers = Bench { model: bench.model.clone(), p: bench.p.clone(), ..bench };
    assert_eq!((bench.cycle().error_id, bench.out.operation_mode), (41, 9));
    answers.inputs.operation_mode_display = 9;
    assert_eq!((answers.cycle().error_id, answers.cycle().spindle_state), (0, VELOCITY));
}

#[test]
fn brake_and_the_start_run_out_of_time_without_samples() {
    let mut bench = Bench::drive().brake();
    bench.inputs.v_actual = f64::NAN;
    assert_eq!((bench.until(|out| out.error_id != 23), bench.out.error_id), (300, 42));
    let mut bench = Bench::drive().brake();
    (bench.inputs.v_actual, bench.inputs.x_actual) = (0.0, f64::NAN);
    assert_eq!((bench.until(|out| out.error_id > 18), bench.out.error_id), (300, 42));
}

#[test]
fn an_error_asks_for_the_mode_of_its_own_cycle() {
    let mut bench = Bench::drive().positioned();
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    bench.cycle();
    let out = bench.once(|i| i.v_interpolator = 9e7);
    assert_eq!((out.spindle_state, out.operation_mode, out.error_id, out.job), (TO_VELOCITY, 9, 44, 0));
}

#[test]
fn a_take_over_beyond_its_window_is_error_46() {
    for index in 0..2 {
        let after = |step: f64, bad: bool| {
            let mut bench = Bench::both().into_iter().nth(index).expect("two");
            bench.cycles(3);
            if bad {
                assert_eq!(bench.once(|i| i.x_command = f64::NAN).error_id, 17);
            }
            bench.inputs.x_command = 100_000.0 + step;
            let first = bench.cycle();
            assert_eq!(first.spindle_state, POSITION);
            bench.inputs.x_command += 5000.0;
            (first.error_id, bench.cycle().error_id)
        };
        assert_eq!([after(1000.0, false), after(-1000.0, false)], [(0, 0); 2]);
        assert_eq!([after(1001.0, false), after(-1001.0, false), after(180_000.0, false)], [(46, 46); 3]);
        assert_eq!([after(360_000.0, false), after(-719_500.0, false)], [(0, 0); 2]);
        // It stays due while there is no sample.
        assert_eq!([after(1001.0, true), after(999.0, true)], [(46, 46), (0, 0)]);
        // After any missing sample, and only then.
        let mut bench = Bench::both().into_iter().nth(index).expect("two").positioned();
        bench.cycle();
        for (step, is_seen) in [(5000.0, true), (0.0, true), (900.0, false), (5000.0, true)] {
            let usual = bench.inputs;
            if !is_seen {
                bench.once(|i| i.v_interpolator = f64::NAN);
            }
            bench.inputs = Inputs { x_command: 100_000.0 + step, ..usual };
            assert_eq!(bench.cycle().error_id, 0, "{step}");
        }
        bench.once(|i| i.v_interpolator = f64::NAN);
        bench.inputs.x_command = 100_000.0;
        assert_eq!((bench.cycle().error_id, bench.cycle().error_id), (46, 46));
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
        assert_eq!((out.spindle_state, out.error_id, out.job), (TO_VELOCITY, id, 1));
        assert!(same(out.v_spindle, FAST) && same(out.x_spindle, x + FAST * 0.002));
        bench.inputs.x_command = x + 2.0 * FAST * 0.002;
        assert_eq!((bench.cycle().spindle_state, bench.out.error_id), (TO_VELOCITY, 0));
        assert_eq!(bench.cycle().spindle_state, VELOCITY);
        let mut bench = Bench::drive().positioned();
        let out = bench.once(|i| {
            change(i);
            i.m5 = true;
        });
        assert_eq!((out.spindle_state, out.error_id, out.loop_closed), (POSITION, id, false));
        assert_eq!((out.waiting, out.job_number), (0, 1), "served all the same");
    }
    let mut bench = Bench::drive().velocity();
    assert_eq!(bench.once(|i| i.v_interpolator = f64::NAN).error_id, 14);
    assert_eq!((bench.once(|i| i.v_actual = f64::NAN).error_id, bench.out.spindle_state), (0, VELOCITY));
}

#[test]
fn brake_brakes_on_with_bad_samples_and_waits_for_good_ones() {
    let mut bench = Bench::drive().brake();
    bench.inputs.v_actual = 0.0;
    bench.cycles(2);
    let v = bench.out.v_spindle;
    let out = bench.once(|i| i.v_actual = f64::NAN);
    assert_eq!((out.spindle_state, out.error_id), (BRAKE, 23));
    assert!(same(out.v_spindle, v - 12_000.0), "{out:?}");
    bench.until(|out| out.v_spindle <= 300_000.0);
    assert_eq!(bench.cycle().spindle_state, BRAKE);
    // Again from here.
    assert_eq!((bench.once(|i| i.v_actual = -1.000_000_1e15).error_id, bench.out.spindle_state), (23, BRAKE));
    // An actual position is read in the third cycle only, and the count goes on.
    assert_eq!(bench.once(|i| i.x_actual = f64::NAN).error_id, 0);
    bench.cycle();
    assert_eq!((bench.once(|i| i.x_actual = f64::NAN).error_id, bench.out.spindle_state), (18, BRAKE));
    assert_eq!((bench.cycle().spindle_state, bench.cycle().spindle_state), (BRAKE, TO_POSITION));
}

#[test]
fn settled_is_slow_by_command_and_not_faster_than_it_by_measurement() {
    let cycles = |v_interpolator, v_actual| {
        let mut bench = Bench::drive().velocity();
        bench.inputs.v_interpolator = v_interpolator;
        bench.once(|i| i.g74 = true);
        bench.inputs.v_actual = v_actual;
        (1..20).find(|_| bench.cycle().spindle_state == TO_POSITION)
    };
    // The first cycle's velocity before is the one of VELOCITY.
    assert_eq!([cycles(300_000.0, 303_000.0), cycles(-300_000.0, 303_000.0)], [Some(4); 2]);
    assert_eq!([cycles(300_001.0, 0.0), cycles(-311_999.0, -303_000.0)], [Some(5); 2]);
    assert_eq!(cycles(312_001.0, 0.0), Some(6));
    assert_eq!([cycles(300_000.0, 303_001.0), cycles(300_000.0, -303_001.0)], [None; 2]);
    assert_eq!([cycles(1000.0, 4000.0), cycles(0.0, -3000.0)], [Some(4); 2]);
    assert_eq!([cycles(1000.0, 4001.0), cycles(0.0, -3001.0)], [None; 2]);
}

#[test]
fn what_is_told_first() {
    let told = |change: fn(&mut Inputs)| {
        let out = Bench::drive().positioned().once(change);
        (out.error_id, out.loop_closed, out.job)
    };
    // What stays, a sample, a request.
    assert_eq!(told(|i| (i.task_cycle_ns, i.g74, i.m5, i.x_command) = (1, true, true, f64::NAN)), (1, false, 0));
    assert_eq!(told(|i| (i.g74, i.m5, i.v_interpolator) = (true, true, f64::NAN)), (14, false, 4));
    assert_eq!(told(|i| (i.g74, i.m5, i.v_interpolator) = (true, true, 1e9)), (44, false, 0));
    assert_eq!(told(|i| (i.m3, i.m4, i.x_command) = (true, true, f64::NAN)), (17, false, 0));
    assert_eq!(told(|i| (i.m5, i.drive_on, i.x_actual) = (true, false, f64::NAN)), (18, false, 0));
    // A refused request does not open the loop.
    assert_eq!(told(|i| (i.g74, i.m5) = (true, true)), (31, true, 4));
    assert_eq!(told(|i| (i.m3, i.m4) = (true, true)), (32, true, 0));
}

#[test]
fn of_the_tests_the_first_is_told() {
    let first = |v, display, x| {
        let mut bench = Bench::drive();
        bench.cycles(3);
        bench.echoes = false;
        let out = bench.once(|i| (i.v_interpolator, i.operation_mode_display, i.x_command) = (v, display, x));
        (out.spindle_state, out.error_id)
    };
    assert_eq!(first(9e7, 9, f64::NAN), (POSITION, 17));
    assert_eq!(first(9e7, 9, 0.0), (POSITION, 45));
    assert_eq!(first(9e7, 8, 0.0), (POSITION, 44));
    assert_eq!(first(0.0, 8, 0.0), (POSITION, 46));
    assert_eq!(first(0.0, 8, 100_000.0), (POSITION, 0));
}

#[test]
fn brake_after_an_error_of_position_control_keeps_its_mode() {
    let mut bench = Bench::drive().positioned();
    assert_eq!(bench.once(|i| i.v_interpolator = 9e7).error_id, 44);
    let out = bench.once(|i| i.reset = true);
    assert_eq!((out.spindle_state, out.operation_mode, out.error_id), (BRAKE, 8, 0));
}

#[test]
fn the_mode_goes_out_with_a_bad_sample_too() {
    let mut bench = Bench::drive().positioned();
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    bench.cycle();
    let out = bench.once(|i| i.x_command = f64::NAN);
    assert_eq!((out.spindle_state, out.operation_mode, out.error_id), (TO_VELOCITY, 9, 17));
}

#[test]
fn a_position_of_brake_is_forgotten_with_the_drive_off() {
    let mut bench = Bench::drive().brake();
    bench.inputs.v_actual = 0.0;
    bench.cycles(3);
    assert_eq!(bench.once(|i| i.drive_on = false).spindle_state, TO_POSITION);
    bench.inputs.x_actual = 7.0;
    assert!(same(bench.cycle().x_spindle, 7.0), "{:?}", bench.out);
}
