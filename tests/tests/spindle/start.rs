//! The first cycles, and the drive off and on again: TO_POSITION at the start.

use super::bench::{Bench, MODE_CYCLES, POSITION_MODE, RPM, V_STEP, VELOCITY_MODE};
use reference::spindle::{Inputs, Job, SpindleState};

#[test]
fn the_start_is_to_position_at_the_actual_position() {
    for mut bench in Bench::both() {
        bench.x_actual = Some(-10_000.0);
        let o = bench.cycle();
        assert_eq!((o.spindle_state, o.x_spindle, o.v_spindle), (SpindleState::ToPosition, 350_000.0, 0.0));
        assert_eq!((o.operation_mode, o.job, o.error_id), (bench.coeffs.position_mode, Job::Stop, 0));
        assert_eq!(bench.next(), SpindleState::Position);
    }
}

#[test]
fn the_start_waits_for_the_display() {
    let mut bench = Bench::in_drive();
    bench.display = Some(VELOCITY_MODE);
    let (first, x) = (bench.cycle(), 90_000.0);
    bench.x_actual = Some(x);
    let second = bench.cycle();
    assert_eq!([first.spindle_state, second.spindle_state], [SpindleState::ToPosition; 2]);
    assert_eq!((second.x_spindle, second.operation_mode), (0.0, POSITION_MODE));
    bench.display = Some(POSITION_MODE);
    bench.cycle();
    assert_eq!(bench.cycle().spindle_state, SpindleState::Position);
}

#[test]
fn the_start_without_a_display_is_error_43_behind_its_time() {
    let mut bench = Bench::in_drive();
    bench.display = Some(0);
    assert_eq!(bench.cycles(MODE_CYCLES).error_id, 0);
    let o = bench.cycle();
    assert_eq!((o.error_id, o.spindle_state), (43, SpindleState::ToPosition));
}

#[test]
fn the_start_waits_for_the_actual_position_with_error_18() {
    for mut bench in Bench::both() {
        bench.x_actual = Some(f64::NAN);
        let o = bench.cycles(MODE_CYCLES);
        assert_eq!((o.error_id, o.spindle_state, o.x_spindle), (18, SpindleState::ToPosition, 0.0));
        bench.x_actual = Some(370_000.0);
        let o = bench.cycle();
        assert_eq!((o.error_id, o.x_spindle, bench.next()), (0, 10_000.0, SpindleState::Position));
    }
}

#[test]
fn the_start_without_an_actual_position_is_error_43_behind_its_time() {
    for mut bench in Bench::both() {
        bench.x_actual = Some(f64::INFINITY);
        assert_eq!(bench.cycles(MODE_CYCLES).error_id, 18);
        assert_eq!(bench.cycle().error_id, 43);
    }
}

/// From each of the five states, and with an error.
#[test]
fn drive_off_leads_to_to_position_on_the_actual_position_from_every_state() {
    let states: [fn(Bench) -> Bench; 5] = [
        Bench::turning,
        Bench::before_to_velocity,
        |bench| bench.fast(1000.0 * RPM),
        |bench| bench.before_brake(1000.0 * RPM),
        Bench::before_to_position,
    ];
    for state in states {
        for bench in Bench::both() {
            let mut bench = state(bench);
            bench.x_actual = Some(-1.0);
            let o = bench.with_inputs(|i| i.drive_on = false);
            assert_eq!((o.spindle_state, o.x_spindle, o.v_spindle), (SpindleState::ToPosition, 359_999.0, 0.0));
            assert_eq!((o.operation_mode, o.job, o.error_id), (bench.coeffs.position_mode, Job::Stop, 0));
            bench.x_actual = Some(5.0);
            let o = bench.cycle();
            assert_eq!((o.spindle_state, o.x_spindle, o.error_id), (SpindleState::ToPosition, 5.0, 0));
        }
    }
}

#[test]
fn drive_off_without_an_actual_position_keeps_the_last_one_with_error_18() {
    let mut bench = Bench::in_drive();
    bench.x_actual = Some(1234.0);
    bench.cycle();
    bench.x_actual = Some(1e15);
    let o = bench.with_inputs(|i| i.drive_on = false);
    assert_eq!((o.x_spindle, o.error_id, o.v_spindle), (1234.0, 18, 0.0));
}

#[test]
fn drive_off_keeps_requests_waiting_and_counts_new_ones() {
    let mut bench = Bench::in_drive().before_brake(1000.0 * RPM);
    assert_eq!(bench.with_inputs(|i| i.drive_on = false).waiting, 1);
    let count = |i: &mut Inputs<f64>| (i.drive_on, i.m5) = (false, true);
    assert_eq!(bench.with_inputs(count).waiting, 2);
    let o = bench.cycle();
    assert_eq!((o.job, o.waiting, bench.next()), (Job::Position, 1, SpindleState::Position));
}

#[test]
fn an_error_that_stays_outlasts_drive_off() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.display = Some(POSITION_MODE);
    assert_eq!(bench.cycle().v_spindle, 1000.0 * RPM - V_STEP);
    bench.display = None;
    let off = bench.with_inputs(|i| i.drive_on = false);
    assert_eq!((off.error_id, off.v_spindle, off.spindle_state), (45, 0.0, SpindleState::ToPosition));
    let on = bench.cycle();
    assert_eq!((on.error_id, on.v_spindle, on.spindle_state), (45, 0.0, SpindleState::ToPosition));
}

#[test]
fn a_wrong_cycle_is_error_1_and_a_cycle_with_the_drive_off() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    let o = bench.with_inputs(|i| i.task_cycle_ns = 1_000_000);
    assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (1, SpindleState::ToPosition, 0.0));
    assert_eq!(bench.with_inputs(|i| i.task_cycle_ns = 0).error_id, 0);
}
