//! The first cycles, and the drive off and on again: TO_POSITION at the start.

use super::bench::{Bench, MODE_CYCLES, POSITION_MODE, RPM, V_STEP, VELOCITY_MODE, wrap};
use reference::spindle::{Inputs, Job, SpindleState};

#[test]
fn the_start_is_to_position_at_the_actual_position() {
    for mut bench in Bench::both() {
        bench.x_actual = Some(-10_000.0);
        let o = bench.cycle();
        assert_eq!((o.spindle_state, o.x_spindle, o.v_spindle), (SpindleState::ToPosition, 350_000.0, 0.0));
        assert_eq!((o.operation_mode, o.job, o.error_id), (bench.coeffs.position_mode, Job::Stop, 0));
        assert_eq!((bench.cycle().spindle_state, bench.next()), (SpindleState::ToPosition, SpindleState::ToPosition));
        assert_eq!((bench.cycle().spindle_state, bench.next()), (SpindleState::ToPosition, SpindleState::Position));
    }
}

#[test]
fn the_start_waits_for_the_display_and_follows_the_actual_position() {
    let mut bench = Bench::in_drive();
    bench.display = Some(VELOCITY_MODE);
    for x in [0.0, 90_000.0, -10_000.0] {
        bench.x_actual = Some(x);
        let o = bench.cycle();
        assert_eq!((o.spindle_state, o.operation_mode), (SpindleState::ToPosition, POSITION_MODE));
        assert_eq!((o.x_spindle, o.v_spindle), (wrap(x), 0.0));
    }
    (bench.x_actual, bench.display) = (Some(123.0), Some(POSITION_MODE));
    assert_eq!(bench.cycle().x_spindle, 123.0);
    assert_eq!(bench.cycle().spindle_state, SpindleState::Position);
}

#[test]
fn the_start_that_loses_the_actual_position_keeps_the_last_one_with_error_18() {
    let mut bench = Bench::in_drive();
    (bench.x_actual, bench.display) = (Some(90_000.0), Some(VELOCITY_MODE));
    bench.cycle();
    (bench.x_actual, bench.display) = (Some(f64::NAN), Some(POSITION_MODE));
    let o = bench.cycle();
    assert_eq!((o.error_id, o.x_spindle, bench.next()), (18, 90_000.0, SpindleState::ToPosition));
}

/// Else a spindle would turn because its PLC has started.
#[test]
fn a_request_that_is_true_in_the_first_cycle_does_not_count() {
    let requests: [fn(&mut Inputs<f64>, bool); 6] = [
        |i, is_asked| i.m3 = is_asked,
        |i, is_asked| i.m4 = is_asked,
        |i, is_asked| i.m5 = is_asked,
        |i, is_asked| i.m19 = is_asked,
        |i, is_asked| i.putax = is_asked,
        |i, is_asked| i.g74 = is_asked,
    ];
    for ask in requests {
        let mut bench = Bench::in_drive();
        ask(&mut bench.inputs, true);
        let o = bench.cycles(5);
        assert_eq!((o.spindle_state, o.job_number, o.waiting), (SpindleState::Position, 0, 0));
        assert_eq!(o.error_id, 0);
        ask(&mut bench.inputs, false);
        bench.cycle();
        ask(&mut bench.inputs, true);
        assert_eq!(bench.cycle().job_number, 1);
    }
}

#[test]
fn the_start_without_a_display_is_error_43_behind_its_time() {
    let mut bench = Bench::in_drive();
    bench.display = Some(0);
    assert_eq!(bench.cycles(MODE_CYCLES + 2).error_id, 0);
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
        assert_eq!(bench.cycles(MODE_CYCLES + 2).error_id, 18);
        assert_eq!(bench.cycle().error_id, 43);
    }
}

/// From each of the five states, and with an error.
#[test]
fn drive_off_leads_to_to_position_on_the_actual_position_from_every_state() {
    for (_, state) in &STATES[1..] {
        for bench in Bench::both() {
            let mut bench = state(bench);
            (bench.x_actual, bench.v_actual) = (Some(-1.0), Some(0.0));
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

/// A spindle must not start by itself when its drive is switched on.
#[test]
fn drive_off_empties_the_queue_and_refuses_requests() {
    let mut bench = Bench::in_drive().before_brake(1000.0 * RPM);
    assert_eq!(bench.outputs.waiting, 1);
    bench.v_actual = Some(0.0);
    assert_eq!(bench.with_inputs(|i| i.drive_on = false).waiting, 0);
    let o = bench.with_inputs(|i| (i.drive_on, i.m5) = (false, true));
    assert_eq!((o.waiting, o.error_id), (0, 36));
    let o = bench.cycles(5);
    assert_eq!((o.job, o.waiting, o.spindle_state), (Job::Stop, 0, SpindleState::Position));
}

#[test]
fn a_request_that_is_still_true_when_the_drive_is_on_does_not_count() {
    let mut bench = Bench::in_drive().at_rest();
    bench.inputs.m3 = true;
    assert_eq!(bench.with_inputs(|i| i.drive_on = false).error_id, 36);
    let o = bench.cycles(5);
    assert_eq!((o.job, o.job_number, o.spindle_state), (Job::Stop, 0, SpindleState::Position));
}

#[test]
fn an_error_that_stays_outlasts_drive_off() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.display = Some(POSITION_MODE);
    assert_eq!(bench.cycles(4).v_spindle, 1000.0 * RPM - V_STEP);
    (bench.display, bench.v_actual) = (None, Some(0.0));
    let off = bench.with_inputs(|i| i.drive_on = false);
    assert_eq!((off.error_id, off.v_spindle, off.spindle_state), (45, 0.0, SpindleState::ToPosition));
    let on = bench.cycle();
    assert_eq!((on.error_id, on.v_spindle, on.spindle_state), (45, 0.0, SpindleState::ToPosition));
}

pub type Way = fn(Bench) -> Bench;

/// Ways to each of the five states, and to the start.
pub const STATES: [(SpindleState, Way); 6] = [
    (SpindleState::ToPosition, |bench| bench),
    (SpindleState::Position, Bench::turning),
    (SpindleState::ToVelocity, Bench::before_to_velocity),
    (SpindleState::Velocity, |bench| bench.fast(1000.0 * RPM)),
    (SpindleState::Brake, |bench| bench.before_brake(1000.0 * RPM)),
    (SpindleState::ToPosition, Bench::before_to_position),
];

#[test]
fn a_wrong_cycle_is_error_1_which_stays_and_stops_in_every_state() {
    for (state, at) in STATES {
        for bench in Bench::both() {
            let mut bench = at(bench);
            let old = bench.outputs;
            let o = bench.with_inputs(|i| i.task_cycle_ns = 1_000_000);
            assert_eq!((o.error_id, o.spindle_state, o.job, o.loop_closed), (1, state, Job::Stop, false));
            assert_eq!((o.v_spindle, o.operation_mode), ((old.v_spindle - V_STEP).max(0.0), old.operation_mode));
            let o = bench.cycles(200);
            assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (1, state, 0.0), "it stays");
            let o = bench.with_inputs(|i| i.reset = true);
            assert_eq!((o.error_id, o.spindle_state), (0, SpindleState::Brake));
        }
    }
}

#[test]
fn a_wrong_cycle_with_the_drive_off_is_error_1_which_stays_in_every_state() {
    for (_, at) in STATES {
        for bench in Bench::both() {
            let mut bench = at(bench);
            bench.v_actual = Some(0.0);
            let o = bench.with_inputs(|i| (i.task_cycle_ns, i.drive_on) = (1_000_000, false));
            assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (1, SpindleState::ToPosition, 0.0));
            assert_eq!(bench.with_inputs(|i| i.drive_on = false).error_id, 1);
            assert_eq!(bench.cycle().error_id, 1);
        }
    }
}

/// Between two cycles with the drive off, and in the one in which it is on again.
#[test]
fn a_wrong_cycle_behind_drive_off_is_error_1_which_stays() {
    for is_on in [false, true] {
        let mut bench = Bench::in_drive().fast(1000.0 * RPM);
        bench.v_actual = Some(0.0);
        bench.with_inputs(|i| i.drive_on = false);
        let o = bench.with_inputs(|i| (i.task_cycle_ns, i.drive_on) = (1_000_000, is_on));
        assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (1, SpindleState::ToPosition, 0.0));
        assert_eq!((bench.cycle().error_id, bench.next()), (1, SpindleState::ToPosition));
    }
}

#[test]
fn a_cycle_of_0_is_not_checked() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.inputs.task_cycle_ns = 0;
    let o = bench.cycles(3);
    assert_eq!((o.error_id, o.spindle_state), (0, SpindleState::Velocity));
}
