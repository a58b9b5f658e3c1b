//! BRAKE, and TO_POSITION after it.

use super::bench::{
    BRAKE_CYCLES, Bench, LEAD_TIME, MODE_CYCLES, POSITION_MODE, RPM, T, V_OFF, V_STEP, V_WINDOW, VELOCITY_MODE,
    assert_angle, wrap,
};
use reference::spindle::{Coeffs, Job, SpindleState};

#[test]
fn brake_goes_down_to_voff_by_the_deceleration() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        for sign in [1.0, -1.0] {
            let mut bench = bench().before_brake(sign * 75.0 * RPM);
            for v in [65.0, 55.0, 50.0, 50.0] {
                let (old, o) = (bench.outputs, bench.cycle());
                assert_eq!((o.spindle_state, o.v_spindle), (SpindleState::Brake, sign * v * RPM));
                assert_eq!(o.operation_mode, bench.coeffs.velocity_mode);
                assert_angle(o.x_spindle, wrap(old.x_spindle + o.v_spindle * T));
            }
        }
    }
}

#[test]
fn brake_does_not_change_a_velocity_below_voff() {
    for v in [0.0, 10.0 * RPM, -V_OFF] {
        let mut bench = Bench::in_drive().before_brake(v);
        assert_eq!(bench.cycle().v_spindle, v);
        assert_eq!(bench.until(SpindleState::ToPosition).v_spindle, v);
    }
}

#[test]
fn brake_does_not_look_at_the_interpolator() {
    let mut bench = Bench::in_drive().before_brake(75.0 * RPM);
    (bench.v, bench.x_command) = (f64::NAN, Some(f64::NAN));
    assert_eq!((bench.cycle().error_id, bench.outputs.v_spindle), (0, 75.0 * RPM - V_STEP));
}

/// Cycles in BRAKE at Voff with these actual velocities, the last one again and again.
fn cycles_in_brake(actual: &[f64]) -> u32 {
    let mut bench = Bench::in_drive().before_brake(V_OFF);
    for cycle in 1.. {
        bench.v_actual = Some(actual[(cycle as usize - 1).min(actual.len() - 1)]);
        bench.cycle();
        if bench.next() != SpindleState::Brake || bench.outputs.fault {
            return cycle;
        }
    }
    unreachable!("its time is over")
}

#[test]
fn brake_to_to_position_after_three_cycles_in_a_row() {
    assert_eq!(cycles_in_brake(&[V_OFF]), 3);
    assert_eq!(cycles_in_brake(&[0.0]), 3);
    assert_eq!(cycles_in_brake(&[V_OFF, V_OFF, 60.0 * RPM, V_OFF]), 6);
}

/// A drive that approaches Voff from above arrives, if it comes into the window.
#[test]
fn brake_to_to_position_within_the_window_and_not_beyond() {
    assert_eq!(cycles_in_brake(&[V_OFF + V_WINDOW]), 3);
    assert_eq!(cycles_in_brake(&[-V_OFF - V_WINDOW]), 3);
    assert_eq!(cycles_in_brake(&[60.0 * RPM, 52.0 * RPM, 50.6 * RPM, 50.5 * RPM]), 6);
    assert_eq!(cycles_in_brake(&[V_OFF + V_WINDOW + 1.0]), BRAKE_CYCLES + 1);
    assert_eq!(cycles_in_brake(&[-V_OFF - V_WINDOW - 1.0]), BRAKE_CYCLES + 1);
}

#[test]
fn brake_with_voff_0_stops() {
    let coeffs = Coeffs {
        v_position_control_on: 0.0,
        v_position_control_on_negative: 0.0,
        window: 100.0,
        ..Bench::in_drive().coeffs
    };
    let mut bench = Bench::with(coeffs).before_brake(15.0 * RPM);
    assert_eq!([bench.cycle().v_spindle, bench.cycle().v_spindle], [5.0 * RPM, 0.0]);
    assert_eq!(bench.until_next(SpindleState::Position).v_spindle, 0.0);
}

#[test]
fn brake_for_too_long_is_error_42_and_stops() {
    let mut bench = Bench::in_drive().before_brake(1000.0 * RPM);
    bench.v_actual = Some(1000.0 * RPM);
    let o = bench.cycles(BRAKE_CYCLES);
    assert_eq!((o.error_id, o.v_spindle), (0, V_OFF));
    let o = bench.cycle();
    assert_eq!((o.error_id, o.v_spindle, o.job), (42, V_OFF - V_STEP, Job::Stop));
    assert_eq!((o.operation_mode, o.spindle_state), (VELOCITY_MODE, SpindleState::Brake));
    assert_eq!(bench.cycles(60).v_spindle, 0.0);
}

#[test]
fn brake_counts_an_unknown_velocity_as_not_settled_with_error_23() {
    let mut bench = Bench::in_drive().before_brake(V_OFF);
    bench.cycles(2);
    bench.v_actual = Some(f64::NAN);
    assert_eq!((bench.cycle().error_id, bench.next()), (23, SpindleState::Brake));
    bench.v_actual = None;
    assert_eq!((bench.cycles(2).error_id, bench.next()), (0, SpindleState::Brake));
    bench.cycle();
    assert_eq!(bench.next(), SpindleState::ToPosition);
}

#[test]
fn brake_is_not_left_without_an_actual_position_and_keeps_its_count() {
    let mut bench = Bench::in_drive().before_brake(V_OFF);
    bench.x_actual = Some(f64::NAN);
    assert_eq!(bench.cycles(2).error_id, 0, "it is not needed yet");
    assert_eq!((bench.cycle().error_id, bench.next()), (18, SpindleState::Brake));
    bench.x_actual = None;
    assert_eq!((bench.cycle().error_id, bench.next()), (0, SpindleState::ToPosition));
}

/// An actual velocity that passes through the window while the command is above Voff, as in a reversal at the current limit.
#[test]
fn brake_is_not_left_before_the_command_has_reached_voff() {
    let mut bench = Bench::in_drive().before_brake(500.0 * RPM);
    for v in [-40.0, -20.0, 0.0, 20.0, 40.0] {
        bench.v_actual = Some(v * RPM);
        let o = bench.cycle();
        let may_leave = o.v_spindle.abs() <= V_OFF;
        assert!(may_leave || bench.next() == SpindleState::Brake, "position control is taken up at {}", o.v_spindle);
    }
}

/// The command of the cycle before: the actual velocity cannot have followed this cycle's.
#[test]
fn brake_counts_from_the_cycle_behind_the_one_whose_command_reaches_voff() {
    let mut bench = Bench::in_drive().before_brake(60.0 * RPM);
    bench.v_actual = Some(0.0);
    assert_eq!(bench.cycle().v_spindle, V_OFF);
    bench.cycles(2);
    assert_eq!(bench.next(), SpindleState::Brake);
    bench.cycle();
    assert_eq!(bench.next(), SpindleState::ToPosition);
}

/// A spindle that turns while the command is 0 has not arrived, slow as it may be.
#[test]
fn brake_compares_the_actual_velocity_with_the_command_and_not_with_voff() {
    for (v, actual, cycles) in [
        (0.0, V_WINDOW, 3),
        (0.0, V_WINDOW + 1.0, BRAKE_CYCLES + 1),
        (0.0, V_OFF, BRAKE_CYCLES + 1),
        (-10.0 * RPM, 10.0 * RPM + V_WINDOW, 3),
        (10.0 * RPM, -10.0 * RPM - V_WINDOW - 1.0, BRAKE_CYCLES + 1),
    ] {
        let mut bench = Bench::in_drive().before_brake(v);
        bench.v_actual = Some(actual);
        bench.cycles(cycles - 1);
        assert_eq!((bench.next(), bench.outputs.error_id), (SpindleState::Brake, 0));
        let error = bench.cycle().error_id;
        assert_eq!(error, if cycles == 3 { 0 } else { 42 }, "{v} {actual}");
        assert_eq!(bench.next(), if cycles == 3 { SpindleState::ToPosition } else { SpindleState::Brake });
    }
}

#[test]
fn brake_without_actual_values_for_too_long_is_error_42() {
    for (x, v, id) in [(f64::NAN, 0.0, 18), (0.0, f64::NAN, 23)] {
        let mut bench = Bench::in_drive().before_brake(V_OFF);
        (bench.x_actual, bench.v_actual) = (Some(x), Some(v));
        assert_eq!((bench.cycles(BRAKE_CYCLES).error_id, bench.cycle().error_id), (id, 42));
    }
}

#[test]
fn to_position_begins_with_the_formula() {
    for (sign, percentage, lead) in [
        (1.0, None, LEAD_TIME),
        (-1.0, None, LEAD_TIME),
        (1.0, Some(0), 0.052),
        (1.0, Some(50), 0.027),
        (1.0, Some(100), T),
    ] {
        let bench = if percentage.is_some() { Bench::in_cnc() } else { Bench::in_drive() };
        let mut bench = bench.before_brake(sign * V_OFF);
        bench.inputs.feedforward_active = true;
        bench.inputs.feedforward_percentage = percentage.unwrap_or(100);
        bench.cycles(2);
        bench.x_actual = Some(359_000.0);
        let v = bench.cycle().v_spindle;
        bench.x_actual = Some(f64::NAN);
        let o = bench.cycle();
        assert_eq!((o.spindle_state, o.operation_mode), (SpindleState::ToPosition, bench.coeffs.position_mode));
        assert_eq!((v, o.v_spindle, o.error_id), (sign * V_OFF, sign * V_OFF, 0));
        assert_angle(o.x_spindle, 359_000.0 + v * lead);
    }
}

/// While the drive has not answered it obeys the velocity.
#[test]
fn to_position_goes_on_by_v_t_and_keeps_the_velocity_until_the_display() {
    let mut bench = Bench::in_drive().before_to_position();
    bench.display = Some(VELOCITY_MODE);
    let mut old = bench.cycle();
    for _ in 1..MODE_CYCLES {
        let o = bench.cycle();
        assert_eq!((o.spindle_state, o.v_spindle, o.velocity_command), (SpindleState::ToPosition, V_OFF, 300_000));
        assert_eq!(o.x_spindle, wrap(old.x_spindle + V_OFF * T));
        old = o;
    }
}

#[test]
fn to_position_ends_when_the_drive_displays_position() {
    let mut bench = Bench::in_drive().before_to_position();
    bench.display = Some(VELOCITY_MODE);
    assert_eq!(bench.cycles(MODE_CYCLES).error_id, 0);
    bench.display = Some(POSITION_MODE);
    let o = bench.cycle();
    assert_eq!((o.spindle_state, o.error_id, bench.next()), (SpindleState::ToPosition, 0, SpindleState::Position));
}

#[test]
fn to_position_takes_one_cycle_in_the_cnc() {
    let mut bench = Bench::in_cnc().before_to_position();
    assert_eq!((bench.cycle().spindle_state, bench.next()), (SpindleState::ToPosition, SpindleState::Position));
}

#[test]
fn to_position_without_an_answer_is_error_43_and_stops() {
    let mut bench = Bench::in_drive().before_to_position();
    bench.display = Some(VELOCITY_MODE);
    assert_eq!(bench.cycles(MODE_CYCLES).error_id, 0);
    let o = bench.cycle();
    assert_eq!((o.error_id, o.v_spindle, o.operation_mode), (43, V_OFF - V_STEP, POSITION_MODE));
    assert_eq!((o.spindle_state, bench.cycles(5).v_spindle), (SpindleState::ToPosition, 0.0));
}

/// The interpolator goes on from v with the job that waited, which has its own speed and direction.
#[test]
fn to_position_begins_the_job_that_waits_for_the_first_cycle_of_position() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.with_inputs(|i| (i.m19, i.m4, i.s_word, i.s_position) = (true, true, 50.0 * RPM, 90_000.0));
    assert_eq!(bench.until_next(SpindleState::ToPosition).job, Job::Stop);
    let o = bench.until_next(SpindleState::Position);
    assert_eq!((o.spindle_state, o.job, o.waiting), (SpindleState::ToPosition, Job::Orient, 0));
    assert_eq!((o.job_speed, o.job_position), (-50.0 * RPM, 90_000.0));
}
