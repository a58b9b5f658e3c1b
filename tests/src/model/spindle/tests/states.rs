//! Each row of the table of states. No formula is here.

use super::bench::{Bench, FAST};
use crate::model::spindle::{BRAKE, POSITION, TO_POSITION, TO_VELOCITY, VELOCITY};

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

#[test]
fn at_the_start_the_position_is_the_actual_one_until_the_drive_answers() {
    let mut bench = Bench::drive();
    (bench.echoes, bench.inputs.x_actual) = (false, -10_000.0);
    let out = bench.cycle();
    assert_eq!((out.spindle_state, out.operation_mode, out.fault, out.loop_closed), (TO_POSITION, 8, false, false));
    assert!(same(out.x_spindle, 350_000.0) && same(out.v_spindle, 0.0));
    bench.inputs.x_actual = 5.0;
    assert!(same(bench.cycle().x_spindle, 5.0), "each cycle's");
    bench.inputs.x_actual = 360_009.0;
    assert!(same(bench.cycle().x_spindle, 9.0));
    // The drive answers, and there is no position.
    bench.inputs.operation_mode_display = 8;
    let out = bench.once(|i| i.x_actual = f64::NAN);
    assert_eq!((out.spindle_state, out.error_id), (TO_POSITION, 18));
    assert!(same(out.x_spindle, 9.0));
    bench.inputs.x_actual = 11.0;
    bench.inputs.x_command = 11.0;
    assert_eq!(bench.cycle().spindle_state, TO_POSITION);
    assert!(same(bench.out.x_spindle, 11.0));
    let out = bench.cycle();
    assert_eq!((out.spindle_state, out.loop_closed, out.error_id), (POSITION, true, 0));
}

#[test]
fn in_the_cnc_each_change_takes_a_cycle_and_nothing_goes_to_a_drive() {
    let mut bench = Bench::cnc();
    bench.inputs.v_interpolator = FAST;
    bench.inputs.operation_mode_display = -77;
    bench.echoes = false;
    bench.inputs.m3 = true;
    bench.inputs.s_word = FAST;
    (0..3).for_each(|_| _ = bench.once(|i| i.m3 = false));
    // The job begins in the first cycle of POSITION.
    assert_eq!((bench.cycle().spindle_state, bench.out.job), (POSITION, 1));
    let states: Vec<i32> = (0..3).map(|_| bench.cycle().spindle_state).collect();
    assert_eq!(states, [POSITION, TO_VELOCITY, VELOCITY]);
    assert_eq!((bench.out.operation_mode, bench.out.velocity_command, bench.out.limited), (0, 0, false));
    (bench.inputs.v_interpolator, bench.inputs.v_actual) = (-200_000.0, 203_000.0);
    bench.once(|i| i.putax = true);
    let states: Vec<i32> = (0..4).map(|_| bench.cycle().spindle_state).collect();
    assert_eq!(states, [BRAKE, BRAKE, BRAKE, TO_POSITION]);
    assert!(same(bench.out.v_spindle, -200_000.0), "{:?}", bench.out);
    assert_eq!((bench.out.job, bench.out.waiting), (3, 0));
    bench.inputs.x_command = bench.out.x_spindle + bench.out.v_spindle * 0.002;
    assert_eq!((bench.cycle().spindle_state, bench.out.error_id), (POSITION, 0));
}

#[test]
fn position_and_to_velocity_follow_the_interpolator() {
    for (mut bench, state) in [
        (Bench::drive().positioned(), POSITION),
        (Bench::cnc().positioned(), POSITION),
        (Bench::drive().changing(), TO_VELOCITY),
    ] {
        (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
        bench.inputs.x_command = -30_000.0;
        let out = bench.once(|i| i.v_interpolator = -70.0);
        assert!(same(out.x_spindle, 330_000.0) && same(out.v_spindle, -70.0), "{out:?}");
        assert_eq!((out.spindle_state, out.error_id, out.loop_closed), (state, 0, state == POSITION));
    }
    assert_eq!(Bench::drive().positioned().out.operation_mode, 8);
    assert_eq!(Bench::drive().changing().out.operation_mode, 9);
}

#[test]
fn velocity_is_the_interpolators_and_the_position_the_actual_one() {
    let mut bench = Bench::drive().velocity();
    bench.inputs.x_actual = 360_007.0;
    let out = bench.once(|i| i.v_interpolator = -6000.0);
    assert!(same(out.x_spindle, 7.0) && same(out.v_spindle, -6000.0), "{out:?}");
    assert_eq!((out.velocity_command, out.operation_mode, out.loop_closed, out.fault), (-10_000, 9, false, false));
    let out = bench.once(|i| (i.x_actual, i.v_interpolator) = (f64::NAN, 5000.0));
    assert!(same(out.x_spindle, 17.0), "{out:?}");
    assert!(!out.fault);
}

#[test]
fn velocity_stays_with_another_s_word_and_with_m5() {
    let mut bench = Bench::drive().velocity();
    assert_eq!(bench.once(|i| (i.m4, i.s_word) = (true, 5.0)).job, 1);
    assert!(same(bench.out.job_speed, -5.0));
    assert_eq!(bench.once(|i| i.m5 = true).job, 0);
    assert_eq!(bench.cycles(50).spindle_state, VELOCITY);
}

#[test]
fn each_other_request_leaves_velocity() {
    for (name, index) in [("m19", 0), ("putax", 1), ("g74", 2)] {
        let mut bench = Bench::drive().velocity();
        let number = bench.out.job_number;
        let out = bench.once(|i| (i.m19, i.putax, i.g74) = (index == 0, index == 1, index == 2));
        assert_eq!((out.spindle_state, out.job, out.job_number, out.waiting), (VELOCITY, 0, number + 1, 1), "{name}");
        let out = bench.cycle();
        assert_eq!((out.spindle_state, out.operation_mode), (BRAKE, 9), "{name}");
    }
}

#[test]
fn to_position_goes_on_from_its_first_position_and_serves_when_the_drive_answers() {
    let mut bench = Bench::drive().back();
    let first = bench.out;
    assert_eq!((first.operation_mode, first.waiting), (8, 1));
    (bench.inputs.x_actual, bench.inputs.v_actual) = (f64::NAN, f64::NAN);
    let v = first.v_spindle;
    let out = bench.cycles(10);
    assert!(same(out.x_spindle, (first.x_spindle + 10.0 * v * 0.002) % 360_000.0), "{first:?} {out:?}");
    assert!(same(out.v_spindle, v));
    bench.inputs.operation_mode_display = 8;
    let out = bench.cycle();
    assert_eq!((out.spindle_state, out.job, out.waiting), (TO_POSITION, 2, 0));
    assert!(same(out.job_speed, 60_000.0) && same(out.job_position, 180_000.0));
    bench.inputs.v_interpolator = v;
    bench.inputs.x_command = out.x_spindle + v * 0.002;
    assert_eq!((bench.cycle().spindle_state, bench.out.loop_closed), (POSITION, true));
}

#[test]
fn m19_never_leaves_position_control_and_a_turn_behind_it_waits() {
    let mut bench = Bench::drive().positioned();
    bench.inputs.v_interpolator = 3_000_000.0;
    bench.once(|i| (i.m19, i.m4, i.s_word) = (true, true, 3_000_000.0));
    assert_eq!((bench.out.job, bench.cycles(9).spindle_state), (2, POSITION));
    assert!(same(bench.out.job_speed, -3_000_000.0));
    bench.once(|i| (i.m3, i.s_word) = (true, 3_000_000.0));
    assert_eq!((bench.cycles(9).spindle_state, bench.out.waiting), (POSITION, 1));
    assert_eq!(bench.once(|i| i.job_done = true).job, 1);
    assert_eq!((bench.cycle().spindle_state, bench.cycle().spindle_state), (POSITION, TO_VELOCITY));
}

#[test]
fn with_von_0_a_turn_changes_at_once() {
    let p = crate::model::spindle::Parameters { v_on: 0.0, v_off: 0.0, ..Bench::drive().p };
    let mut bench = Bench::new(&p).positioned();
    bench.once(|i| i.m3 = true);
    assert_eq!(bench.cycle().spindle_state, POSITION);
    bench.once(|i| (i.m3, i.s_word) = (true, 1.0));
    assert_eq!((bench.cycle().spindle_state, bench.cycle().spindle_state), (POSITION, TO_VELOCITY));
}

#[test]
fn the_time_of_each_state_that_waits_ends_with_its_error() {
    let mut bench = Bench::drive();
    bench.echoes = false;
    assert_eq!((bench.until(|out| out.fault), bench.out.error_id), (23, 43));
    let mut bench = Bench::drive().changing();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    assert_eq!((bench.until(|out| out.fault), bench.out.error_id, bench.out.job), (20, 41, 0));
    assert_eq!(bench.out.operation_mode, 9);
    let mut bench = Bench::drive().brake();
    bench.inputs.v_actual = 303_001.0;
    assert_eq!((bench.until(|out| out.fault), bench.out.error_id), (300, 42));
    let mut bench = Bench::drive().back();
    let v = bench.out.v_spindle;
    assert_eq!((bench.until(|out| out.fault), bench.out.error_id), (20, 43));
    assert!(same(bench.out.v_spindle, v - 12_000.0), "{:?}", bench.out);
}

#[test]
fn the_velocity_of_the_interpolator_decides_and_not_the_one_that_is_put_out() {
    let mut bench = Bench::drive().positioned();
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| i.x_command = f64::NAN);
    assert_eq!((bench.cycle().spindle_state, bench.cycle().spindle_state), (POSITION, TO_VELOCITY));
}

#[test]
fn a_job_that_begins_in_a_cycle_acts_in_the_next_one() {
    let mut bench = Bench::drive().positioned();
    bench.inputs.v_interpolator = FAST;
    bench.once(|i| (i.m3, i.s_word) = (true, FAST));
    assert_eq!((bench.out.job, bench.out.spindle_state), (1, POSITION));
    // M5 in the cycle that changes does not keep it, a reset does.
    let mut other = Bench::drive().positioned();
    other.inputs.v_interpolator = FAST;
    other.once(|i| (i.m3, i.s_word) = (true, FAST));
    let out = bench.once(|i| i.m5 = true);
    assert_eq!((out.spindle_state, out.job, out.waiting), (POSITION, 1, 1));
    let out = other.once(|i| i.reset = true);
    assert_eq!((out.spindle_state, out.job, out.waiting), (POSITION, 0, 0));
    assert_eq!(bench.cycle().spindle_state, TO_VELOCITY);
    assert_eq!(bench.cycles(9).spindle_state, VELOCITY);
    assert_eq!(other.cycles(9).spindle_state, POSITION);
}
