//! The drive comes on next to a spindle that turns: it is caught at its velocity, or taken hold of where it is slow.

use super::bench::{
    BRAKE_CYCLES, Bench, LEAD_TIME, MODE_CYCLES, POSITION_MODE, RPM, T, V_OFF, V_STEP, V_WINDOW, VELOCITY_MODE,
    assert_angle, wrap,
};
use reference::spindle::{Coeffs, Inputs, Job, SpindleState};

const FAST: f64 = 1000.0 * RPM;

/// A block that starts next to a spindle that turns; its drive displays `display`.
fn beside(mut bench: Bench, v: f64) -> Bench {
    (bench.x_actual, bench.v_actual) = (Some(90_000.0), Some(v));
    bench
}

/// Until POSITION, with a drive that follows; no faster than Voff and the window, and never the other way.
fn assert_arrives(bench: &mut Bench, direction: f64) {
    (bench.x_actual, bench.v_actual, bench.display) = (None, None, None);
    for _ in 0..2000 {
        let v_actual = bench.outputs.v_spindle;
        bench.v = v_actual - v_actual.clamp(-V_STEP, V_STEP);
        let o = bench.cycle();
        assert!(o.spindle_state != SpindleState::Position || v_actual.abs() <= V_OFF + V_WINDOW, "{o:?}");
        assert!(o.v_spindle * direction >= 0.0 && o.error_id == 0, "{o:?}");
        if o.spindle_state == SpindleState::Position && o.v_spindle == 0.0 {
            return;
        }
    }
    panic!("{:?}", bench.outputs);
}

/// The drive is off for 10 ms at 1000 rpm.
#[test]
fn a_drive_that_drops_out_in_velocity_is_caught_at_its_velocity() {
    for bench in Bench::both() {
        for v in [FAST, -FAST] {
            let mut bench = Bench::with(bench.coeffs).fast(v);
            (bench.x_actual, bench.v_actual) = (Some(90_000.0), Some(v));
            bench.inputs.drive_on = false;
            bench.cycles(5);
            bench.inputs.drive_on = true;
            let o = bench.cycle();
            assert_eq!((o.spindle_state, o.v_spindle, o.loop_closed), (SpindleState::ToPosition, v, false));
            assert_eq!((o.operation_mode, o.job, o.error_id), (bench.coeffs.velocity_mode, Job::Stop, 0));
            assert_angle(o.x_spindle, wrap(90_000.0 + v * (bench.coeffs.lead_time - T)));
            let o = bench.cycle();
            assert_eq!((o.spindle_state, o.v_spindle), (SpindleState::Brake, v - V_STEP.copysign(v)));
            assert_eq!(o.operation_mode, bench.coeffs.velocity_mode);
            assert_arrives(&mut bench, v);
        }
    }
}

#[test]
fn the_start_beside_a_fast_spindle_goes_with_it_for_three_cycles_and_brakes_then() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        let mut bench = beside(bench(), -FAST);
        for _ in 0..3 {
            let o = bench.cycle();
            assert_eq!((o.spindle_state, o.v_spindle, o.error_id), (SpindleState::ToPosition, -FAST, 0));
            assert_eq!(o.operation_mode, bench.coeffs.velocity_mode);
        }
        assert_eq!(bench.cycle().spindle_state, SpindleState::Brake);
        assert_arrives(&mut bench, -1.0);
    }
}

/// As fast as BRAKE may leave it, and a little faster.
#[test]
fn the_start_beside_a_spindle_at_voff_and_the_window_needs_no_brake() {
    for (v, next) in [(V_OFF + V_WINDOW, SpindleState::ToPosition), (V_OFF + V_WINDOW + 1.0, SpindleState::Brake)] {
        let mut bench = beside(Bench::in_drive(), v);
        bench.cycles(3);
        assert_eq!((bench.next(), bench.state.is_moving), (next, true));
        let o = bench.cycle();
        assert_eq!(o.spindle_state, next);
        if next == SpindleState::ToPosition {
            assert_eq!((o.v_spindle, o.operation_mode), (v, POSITION_MODE));
            assert_angle(o.x_spindle, wrap(90_000.0 + v * LEAD_TIME));
        }
        assert_arrives(&mut bench, 1.0);
    }
}

#[test]
fn a_spindle_within_the_window_stands() {
    let mut bench = beside(Bench::in_drive(), V_WINDOW);
    let o = bench.cycle();
    assert_eq!((o.v_spindle, o.x_spindle, o.operation_mode), (0.0, 90_000.0, POSITION_MODE));
    bench.cycles(2);
    assert_eq!(bench.next(), SpindleState::Position);
}

/// The median: not the last sample, and not the mean.
#[test]
fn one_wild_sample_is_none_of_the_velocity() {
    let mut bench = beside(Bench::in_drive(), FAST);
    bench.cycles(2);
    bench.v_actual = Some(-8.0 * FAST);
    assert_eq!((bench.cycle().v_spindle, bench.next()), (FAST, SpindleState::Brake));
    let mut bench = beside(Bench::in_drive(), 0.0);
    bench.cycles(2);
    bench.v_actual = Some(FAST);
    assert_eq!((bench.cycle().v_spindle, bench.next()), (0.0, SpindleState::ToPosition));
    bench.v_actual = Some(0.0);
    bench.cycles(2);
    assert_eq!(bench.next(), SpindleState::ToPosition, "three slow ones in a row");
    bench.cycle();
    assert_eq!(bench.next(), SpindleState::Position);
}

#[test]
fn cycles_with_the_drive_off_count() {
    let mut bench = beside(Bench::in_drive(), 0.0);
    bench.inputs.drive_on = false;
    bench.cycles(9);
    bench.inputs.drive_on = true;
    bench.cycle();
    assert_eq!(bench.next(), SpindleState::Position);
}

#[test]
fn the_start_without_the_actual_velocity_is_error_23_and_43_behind_its_time() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        let mut bench = beside(bench(), FAST);
        bench.cycle();
        bench.v_actual = Some(f64::NAN);
        let old = bench.outputs;
        let o = bench.cycles(MODE_CYCLES + 1);
        assert_eq!((o.error_id, o.v_spindle, o.operation_mode), (23, FAST, old.operation_mode), "not released");
        let o = bench.cycle();
        assert_eq!((o.error_id, o.v_spindle, o.spindle_state), (43, FAST - V_STEP, SpindleState::ToPosition));
        // The samples before are forgotten, with the reset too.
        bench.v_actual = Some(FAST);
        bench.with_inputs(|i| i.reset = true);
        assert_eq!((bench.cycle().spindle_state, bench.next()), (SpindleState::ToPosition, SpindleState::ToPosition));
        bench.cycle();
        assert_eq!(bench.next(), SpindleState::Brake);
        assert_arrives(&mut bench, 1.0);
    }
}

/// The position command goes on with the ramp, for a drive that still obeys it.
#[test]
fn a_drive_that_does_not_display_velocity_when_it_catches_is_error_41() {
    let mut bench = beside(Bench::in_drive(), FAST);
    bench.display = Some(POSITION_MODE);
    bench.cycles(3);
    for _ in 0..MODE_CYCLES {
        let (old, o) = (bench.outputs, bench.cycle());
        assert_eq!((o.spindle_state, o.error_id, o.operation_mode), (SpindleState::Brake, 0, VELOCITY_MODE));
        assert_eq!(o.v_spindle, old.v_spindle - V_STEP);
        assert_angle(o.x_spindle, wrap(old.x_spindle + o.v_spindle * T));
    }
    let o = bench.cycle();
    assert_eq!((o.error_id, o.spindle_state), (41, SpindleState::Brake));
    assert_eq!(bench.cycles(200).v_spindle, 0.0);
}

#[test]
fn a_caught_spindle_whose_drive_has_answered_has_the_time_of_brake() {
    let mut bench = beside(Bench::in_drive(), FAST);
    bench.cycles(4);
    bench.display = Some(POSITION_MODE);
    assert_eq!(bench.cycles(BRAKE_CYCLES - 1).error_id, 0);
    assert_eq!(bench.cycle().error_id, 42);
}

#[test]
fn a_drive_without_velocity_control_is_waited_for_with_error_47() {
    let mut bench = beside(Bench::with(Coeffs { only_position: true, ..Bench::in_drive().coeffs }), FAST);
    bench.cycles(2);
    let o = bench.cycles(100);
    assert_eq!((o.error_id, o.spindle_state, o.operation_mode), (47, SpindleState::ToPosition, POSITION_MODE));
    assert!(!o.loop_closed);
    bench.v_actual = Some(0.0);
    assert_eq!((bench.cycles(3).error_id, bench.next()), (0, SpindleState::Position));
}

#[test]
fn a_drive_with_velocity_control_alone_starts_in_velocity_and_refuses_positions() {
    let alone = Coeffs {
        only_velocity: true,
        v_velocity_control_on: 0.0,
        v_position_control_on: 0.0,
        v_position_control_on_negative: 0.0,
        v_taken_up: V_WINDOW,
        position_mode: VELOCITY_MODE,
        ..Bench::in_drive().coeffs
    };
    let mut bench = Bench::with(alone);
    (bench.x_actual, bench.display) = (Some(f64::NAN), Some(0));
    let o = bench.cycles(3);
    assert_eq!((o.error_id, o.operation_mode, bench.next()), (0, VELOCITY_MODE, SpindleState::Velocity));
    let requests: [fn(&mut Inputs<f64>); 3] = [|i| i.m19 = true, |i| i.g74 = true, |i| i.putax = true];
    for ask in requests {
        let o = bench.with_inputs(ask);
        assert_eq!((o.error_id, o.waiting, o.spindle_state), (49, 0, SpindleState::Velocity));
        bench.cycle();
    }
    assert_eq!(bench.with_inputs(|i| i.m3 = true).job, Job::Turn);
    bench.v = FAST;
    assert_eq!((bench.cycle().v_spindle, bench.outputs.error_id), (FAST, 0));
    bench.with_inputs(|i| i.reset = true);
    assert_eq!(bench.cycle().v_spindle, FAST - V_STEP);
    bench.v = 0.0;
    let o = bench.until(SpindleState::Velocity);
    assert_eq!((o.v_spindle, o.job, o.error_id), (0.0, Job::Stop, 0));
    // A spindle that turns is caught as any other.
    bench.v_actual = Some(FAST);
    bench.inputs.drive_on = false;
    bench.cycles(3);
    bench.inputs.drive_on = true;
    assert_eq!((bench.cycle().v_spindle, bench.next()), (FAST, SpindleState::Brake));
}

/// The drive is off and on again while an error stays: it is braked from the velocity that it has then.
#[test]
fn an_error_that_outlasts_the_drive_takes_hold_of_the_spindle() {
    for off in [1, 3, 200] {
        let mut bench = Bench::in_drive().fast(FAST);
        bench.v_actual = Some(FAST);
        bench.x_actual = Some(90_000.0);
        bench.with_inputs(|i| i.task_cycle_ns = 1);
        bench.inputs.drive_on = false;
        bench.cycles(off);
        bench.inputs.drive_on = true;
        let o = bench.cycle();
        assert_eq!((o.error_id, o.v_spindle, o.operation_mode), (1, FAST, VELOCITY_MODE));
        assert_angle(o.x_spindle, wrap(90_000.0 + FAST * (LEAD_TIME - T)));
        let o = bench.cycle();
        assert_eq!((o.error_id, o.v_spindle, o.operation_mode), (1, FAST - V_STEP, VELOCITY_MODE));
        bench.v_actual = None;
        let o = bench.with_inputs(|i| i.reset = true);
        assert_eq!((o.error_id, o.spindle_state), (0, SpindleState::Brake));
        assert_arrives(&mut bench, 1.0);
    }
}

/// A PLC that says so of a drive that is on: the spindle brakes as by a reset.
#[test]
fn drive_off_brakes_by_the_deceleration_and_not_beyond_the_spindle() {
    for bench in Bench::both() {
        let mut bench = bench.fast(FAST);
        bench.inputs.drive_on = false;
        for _ in 0..95 {
            let (old, o) = (bench.outputs, bench.cycle());
            assert_eq!(o.v_spindle, old.v_spindle - V_STEP);
            assert_eq!((o.operation_mode, o.spindle_state), (bench.coeffs.velocity_mode, SpindleState::ToPosition));
        }
        assert_eq!(bench.cycles(6).v_spindle, 0.0);
        assert_eq!(bench.cycles(2).operation_mode, bench.coeffs.position_mode);
        let mut bench = Bench::with(bench.coeffs).fast(FAST);
        bench.inputs.drive_on = false;
        bench.v_actual = Some(300.0 * RPM);
        assert_eq!(bench.cycle().v_spindle, 300.0 * RPM);
        bench.v_actual = Some(-300.0 * RPM);
        assert_eq!(bench.cycles(2).v_spindle, 0.0, "not against the spindle");
        bench.v_actual = Some(f64::NAN);
        let o = bench.cycle();
        assert_eq!((o.error_id, o.operation_mode), (0, bench.coeffs.velocity_mode), "nothing is known, the mode stays");
    }
}

/// A loop that is the block's own, as in `spindle_axis`.
#[test]
fn the_loop_in_the_cnc_without_an_actual_position_is_open_and_the_fourth_cycle_stops() {
    let closed = Coeffs { closes_loop: true, ..Bench::in_cnc().coeffs };
    let mut bench = Bench::with(closed).turning();
    bench.v = 60.0 * RPM;
    assert!(bench.cycles(3).loop_closed);
    bench.x_actual = Some(f64::NAN);
    for _ in 0..3 {
        let o = bench.cycle();
        assert_eq!((o.error_id, o.v_spindle, o.loop_closed), (18, 60.0 * RPM, false));
    }
    let o = bench.cycle();
    assert_eq!((o.error_id, o.v_spindle, o.job), (18, 60.0 * RPM - V_STEP, Job::Stop));
    bench.x_actual = None;
    assert_eq!(bench.cycle().error_id, 18, "it stays");
    let mut other = Bench::in_cnc().turning();
    other.x_actual = Some(f64::NAN);
    assert_eq!((other.cycle().error_id, other.outputs.loop_closed), (0, true), "the loop of another block");
}
