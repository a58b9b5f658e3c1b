//! POSITION, its transition to TO_VELOCITY, and its first cycle after TO_POSITION.

use super::bench::{Bench, POSITION_MODE, RPM, T, V_ON, VELOCITY_MODE, WINDOW, assert_angle, wrap};
use reference::spindle::{Coeffs, Inputs, Job, SpindleState};

#[test]
fn position_puts_out_what_the_interpolator_gives() {
    for bench in Bench::both() {
        let mut bench = bench.at_rest();
        (bench.v, bench.x_command) = (123.0, Some(-90_000.0));
        let o = bench.cycle();
        assert_eq!((o.x_spindle, o.v_spindle, o.loop_closed), (270_000.0, 123.0, true));
        assert_eq!((o.operation_mode, o.error_id), (bench.coeffs.position_mode, 0));
    }
}

/// With S and the interpolator at a velocity: whether POSITION is left.
fn leaves(mut bench: Bench, s: f64, v: f64) -> bool {
    bench.inputs.s_word = s;
    let mut bench = bench.turning();
    bench.v = v;
    bench.cycle();
    bench.next() == SpindleState::ToVelocity
}

#[test]
fn position_to_velocity_needs_more_than_von() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        assert!(!leaves(bench(), V_ON, 2.0 * V_ON), "S = Von stays");
        assert!(!leaves(bench(), V_ON - 1.0, 2.0 * V_ON));
        assert!(leaves(bench(), V_ON + 1.0, 2.0 * V_ON));
        assert!(leaves(bench(), -V_ON - 1.0, 2.0 * V_ON), "the sign of S does not matter");
    }
}

#[test]
fn position_to_velocity_needs_von_to_be_reached() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        assert!(!leaves(bench(), 2.0 * V_ON, V_ON - 1.0));
        assert!(leaves(bench(), 2.0 * V_ON, V_ON));
        assert!(leaves(bench(), 2.0 * V_ON, -V_ON), "either direction");
        assert!(!leaves(bench(), 2.0 * V_ON, 1.0 - V_ON));
    }
}

#[test]
fn position_to_velocity_for_m4() {
    let mut bench = Bench::in_drive().at_rest();
    let o = bench.with_inputs(|i| i.m4 = true);
    assert_eq!((o.job, o.job_speed), (Job::Turn, -1000.0 * RPM));
    bench.v = -V_ON;
    let o = bench.cycle();
    assert_eq!((o.spindle_state, bench.next()), (SpindleState::Position, SpindleState::ToVelocity));
}

#[test]
fn position_to_velocity_at_once_with_von_0() {
    let coeffs = Coeffs { v_velocity_control_on: 0.0, ..Bench::in_drive().coeffs };
    assert!(leaves(Bench::with(coeffs), 1.0, 0.0));
    assert!(!leaves(Bench::with(coeffs), 0.0, 0.0), "S 0 is not more than Von");
}

/// The special case of the manual: 500 rpm, Von 200 rpm.
#[test]
fn position_is_not_left_for_m19_faster_than_von() {
    for bench in Bench::both() {
        let mut bench = bench.at_rest();
        bench.inputs.s_word = 500.0 * RPM;
        assert_eq!(bench.with_inputs(|i| i.m19 = true).job_speed, 500.0 * RPM);
        bench.v = 500.0 * RPM;
        let o = bench.cycles(100);
        assert_eq!((o.spindle_state, o.job, o.error_id), (SpindleState::Position, Job::Orient, 0));
    }
}

#[test]
fn position_is_not_left_for_another_job_than_turn() {
    let requests: [fn(&mut Inputs<f64>); 3] = [|i| i.m5 = true, |i| i.putax = true, |i| i.g74 = true];
    for ask in requests {
        let mut bench = Bench::in_drive().at_rest();
        bench.with_inputs(ask);
        bench.v = 1000.0 * RPM;
        assert_eq!(bench.cycles(3).spindle_state, SpindleState::Position);
    }
}

#[test]
fn position_without_a_sample_goes_on_with_its_id() {
    let mut bench = Bench::in_drive().at_rest();
    bench.v = 100.0 * RPM;
    let old = bench.cycle();
    bench.x_command = Some(f64::NAN);
    let o = bench.cycle();
    assert_eq!((o.error_id, o.v_spindle, o.loop_closed, o.fault), (17, old.v_spindle, false, true));
    assert_eq!(o.x_spindle, wrap(old.x_spindle + old.v_spindle * T));
    bench.v = f64::NEG_INFINITY;
    let o = bench.cycle();
    assert_eq!((o.error_id, o.v_spindle), (14, old.v_spindle), "the velocity is looked at first");
    assert_eq!(bench.next(), SpindleState::Position);
}

#[test]
fn position_without_a_sample_is_not_left() {
    let mut bench = Bench::in_drive().turning();
    bench.v = 2.0 * V_ON;
    bench.x_command = Some(7.1e14);
    assert_eq!(bench.cycle().error_id, 17);
    assert_eq!(bench.next(), SpindleState::Position);
}

#[test]
fn position_does_not_look_at_actual_values() {
    let mut bench = Bench::in_drive().at_rest();
    (bench.x_actual, bench.v_actual) = (Some(f64::NAN), Some(f64::NAN));
    assert_eq!(bench.cycle().error_id, 0);
}

#[test]
fn position_in_another_mode_is_a_missing_sample_with_error_45() {
    let mut bench = Bench::in_drive().at_rest();
    bench.v = 100.0 * RPM;
    let old = bench.cycle();
    (bench.v, bench.display) = (101.0 * RPM, Some(VELOCITY_MODE));
    let o = bench.cycle();
    assert_eq!((o.error_id, o.spindle_state, o.loop_closed), (45, SpindleState::Position, false));
    assert_eq!((o.v_spindle, o.x_spindle), (old.v_spindle, wrap(old.x_spindle + old.v_spindle * T)));
    let mut bench = Bench::in_cnc().at_rest();
    bench.display = Some(VELOCITY_MODE);
    assert_eq!(bench.cycle().error_id, 0, "nothing is displayed with position control in the CNC");
}

/// A cycle in which a sample is missing.
fn lack(bench: &mut Bench, id: u32) {
    let (v, x_command, display) = (bench.v, bench.x_command, bench.display);
    match id {
        14 => bench.v = f64::NAN,
        17 => bench.x_command = Some(f64::INFINITY),
        _ => bench.display = Some(VELOCITY_MODE),
    }
    bench.cycle();
    (bench.v, bench.x_command, bench.display) = (v, x_command, display);
}

#[test]
fn the_fourth_cycle_of_position_without_a_sample_stops() {
    for id in [14, 17, 45] {
        let mut bench = Bench::in_drive().at_rest();
        bench.v = 100.0 * RPM;
        bench.cycle();
        for _ in 0..3 {
            lack(&mut bench, id);
            assert_eq!((bench.outputs.error_id, bench.outputs.v_spindle), (id, 100.0 * RPM));
        }
        lack(&mut bench, id);
        assert_eq!((bench.outputs.error_id, bench.outputs.v_spindle), (id, 90.0 * RPM));
        assert_eq!((bench.cycle().error_id, bench.outputs.v_spindle), (id, 80.0 * RPM), "it stays");
    }
}

/// The error is the fourth one's, whichever sample the others have missed.
#[test]
fn missing_samples_of_different_kinds_are_counted_together() {
    let mut bench = Bench::in_drive().at_rest();
    for id in [14, 17, 45, 17] {
        lack(&mut bench, id);
    }
    assert_eq!((bench.outputs.error_id, bench.cycle().error_id), (17, 17));
}

#[test]
fn a_cycle_of_position_with_all_samples_counts_anew() {
    let mut bench = Bench::in_drive().at_rest();
    for _ in 0..3 {
        for id in [14, 17, 45] {
            lack(&mut bench, id);
        }
        let o = bench.cycle();
        assert_eq!((o.error_id, o.loop_closed), (0, true));
    }
}

#[test]
fn the_step_of_position_behind_missing_samples_is_looked_at() {
    for id in [14, 17, 45] {
        for (off, error) in [(0.999 * WINDOW, 0), (1.001 * WINDOW, 46), (180_000.0, 46)] {
            let mut bench = Bench::in_drive().at_rest();
            bench.v = 100.0 * RPM;
            bench.cycle();
            lack(&mut bench, id);
            bench.x_command = Some(bench.outputs.x_spindle + bench.outputs.v_spindle * T + off);
            assert_eq!(bench.cycle().error_id, error, "{id} {off}");
        }
    }
}

#[test]
fn the_step_of_to_velocity_behind_missing_samples_is_looked_at() {
    for id in [14, 17] {
        for (off, error) in [(0.999 * WINDOW, 0), (1.001 * WINDOW, 46), (180_000.0, 46)] {
            let mut bench = Bench::in_drive().before_to_velocity();
            bench.display = Some(POSITION_MODE);
            bench.cycle();
            lack(&mut bench, id);
            bench.x_command = Some(bench.outputs.x_spindle + bench.outputs.v_spindle * T + off);
            let o = bench.cycle();
            assert_eq!((o.error_id, o.spindle_state), (error, SpindleState::ToVelocity), "{id} {off}");
        }
    }
}

#[test]
fn loop_closed_does_not_depend_on_a_refused_request() {
    let mut bench = Bench::in_drive().at_rest();
    let o = bench.with_inputs(|i| (i.m3, i.m4) = (true, true));
    assert_eq!((o.error_id, o.fault, o.loop_closed), (32, true, true));
}

/// Missing samples, then the half turn, then the take-over.
#[test]
fn position_looks_at_its_samples_first_and_at_the_half_turn_next() {
    let far = || {
        let mut bench = Bench::in_drive().before_takeover();
        (bench.v, bench.x_command) = (15_000.0 * RPM, Some(bench.outputs.x_spindle + 90_000.0));
        bench
    };
    let mut bench = far();
    bench.display = Some(0);
    assert_eq!(bench.cycle().error_id, 45);
    assert_eq!(far().cycle().error_id, 44);
    let mut bench = far();
    bench.v = 0.0;
    assert_eq!(bench.cycle().error_id, 46);
}

#[test]
fn the_first_step_of_position_may_be_off_by_the_window() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        for off in [0.0, 0.999 * WINDOW, -0.999 * WINDOW] {
            let mut bench = bench().before_takeover();
            let next = bench.outputs.x_spindle + bench.outputs.v_spindle * T;
            bench.x_command = Some(next + off - 360_000.0);
            let o = bench.cycle();
            assert_eq!((o.spindle_state, o.error_id, o.loop_closed), (SpindleState::Position, 0, true));
            assert_angle(o.x_spindle, next + off);
        }
    }
}

#[test]
fn the_first_step_of_position_beyond_the_window_is_error_46() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        for off in [1.001 * WINDOW, -1.001 * WINDOW, 180_000.0] {
            let mut bench = bench().before_takeover();
            bench.x_command = Some(bench.outputs.x_spindle + bench.outputs.v_spindle * T + off);
            assert_eq!(bench.cycle().error_id, 46);
        }
    }
}

#[test]
fn only_the_first_step_of_position_is_looked_at() {
    let mut bench = Bench::in_drive().before_takeover();
    bench.cycle();
    bench.x_command = Some(bench.outputs.x_spindle + 90_000.0);
    assert_eq!(bench.cycle().error_id, 0);
}

#[test]
fn the_first_step_of_position_with_samples_is_looked_at() {
    let mut bench = Bench::in_drive().before_takeover();
    bench.x_command = Some(f64::NAN);
    assert_eq!(bench.cycle().error_id, 17);
    bench.x_command = Some(bench.outputs.x_spindle + 90_000.0);
    assert_eq!((bench.cycle().error_id, bench.outputs.operation_mode), (46, POSITION_MODE));
}
