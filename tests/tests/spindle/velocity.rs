//! TO_VELOCITY and VELOCITY, and what leads out of them.

use super::bench::{Bench, MODE_CYCLES, POSITION_MODE, RPM, T, V_OFF, V_STEP, VELOCITY_MODE, assert_angle, wrap};
use reference::spindle::{Inputs, Job, SpindleState};

#[test]
fn to_velocity_keeps_both_commands_and_asks_for_velocity() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    (bench.v, bench.x_command) = (1001.0 * RPM, Some(370_000.0));
    let o = bench.cycle();
    assert_eq!((o.spindle_state, o.operation_mode), (SpindleState::ToVelocity, VELOCITY_MODE));
    assert_eq!((o.x_spindle, o.v_spindle, o.velocity_command), (10_000.0, 1001.0 * RPM, 6_006_000));
    assert_eq!((o.loop_closed, o.error_id), (false, 0));
}

#[test]
fn to_velocity_ends_when_the_drive_displays_velocity() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    assert_eq!(bench.cycles(3).spindle_state, SpindleState::ToVelocity);
    bench.display = Some(VELOCITY_MODE);
    assert_eq!(bench.cycle().spindle_state, SpindleState::ToVelocity);
    assert_eq!(bench.cycle().spindle_state, SpindleState::Velocity);
}

#[test]
fn to_velocity_takes_one_cycle_in_the_cnc() {
    let mut bench = Bench::in_cnc().before_to_velocity();
    assert_eq!(bench.cycle().spindle_state, SpindleState::ToVelocity);
    assert_eq!(bench.cycle().spindle_state, SpindleState::Velocity);
}

#[test]
fn to_velocity_answered_behind_the_last_cycle_of_its_time_goes_on() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    assert_eq!(bench.cycles(MODE_CYCLES).error_id, 0);
    bench.display = Some(VELOCITY_MODE);
    assert_eq!((bench.cycle().error_id, bench.next()), (0, SpindleState::Velocity));
}

#[test]
fn to_velocity_without_an_answer_is_error_41_and_stops() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    assert_eq!(bench.cycles(MODE_CYCLES).error_id, 0);
    let o = bench.cycle();
    assert_eq!((o.error_id, o.job, o.v_spindle), (41, Job::Stop, 1000.0 * RPM - V_STEP));
    assert_eq!((o.spindle_state, o.operation_mode), (SpindleState::ToVelocity, VELOCITY_MODE));
    let o = bench.cycles(100);
    assert_eq!((o.error_id, o.v_spindle), (41, 0.0));
}

#[test]
fn to_velocity_without_a_sample_goes_on_with_its_id() {
    for (v, x, id) in [(f64::NAN, 0.0, 14), (1000.0 * RPM, f64::NAN, 17)] {
        let mut bench = Bench::in_drive().before_to_velocity();
        let old = bench.outputs;
        (bench.v, bench.x_command) = (v, Some(x));
        bench.display = Some(VELOCITY_MODE);
        let o = bench.cycle();
        assert_eq!((o.error_id, o.v_spindle), (id, old.v_spindle));
        assert_angle(o.x_spindle, old.x_spindle + old.v_spindle * T);
        assert_eq!(bench.next(), SpindleState::ToVelocity);
    }
}

#[test]
fn the_fourth_cycle_of_to_velocity_without_a_sample_stops() {
    for (v, x, id) in [(f64::NAN, 0.0, 14), (1000.0 * RPM, f64::NAN, 17)] {
        for bench in Bench::both() {
            let mut bench = bench.before_to_velocity();
            (bench.v, bench.x_command) = (v, Some(x));
            let o = bench.cycles(3);
            assert_eq!((o.error_id, o.v_spindle), (id, 1000.0 * RPM));
            let o = bench.cycle();
            assert_eq!((o.error_id, o.v_spindle, o.job), (id, 1000.0 * RPM - V_STEP, Job::Stop));
            assert_eq!((o.spindle_state, o.operation_mode), (SpindleState::ToVelocity, bench.coeffs.velocity_mode));
            (bench.v, bench.x_command) = (0.0, None);
            assert_eq!(bench.cycle().error_id, id, "it stays");
        }
    }
}

/// The time runs in cycles without a sample, but error 41 needs one with all samples.
#[test]
fn the_time_of_to_velocity_runs_without_samples_and_is_over_with_them() {
    for (display, error, next) in
        [(POSITION_MODE, 41, SpindleState::ToVelocity), (VELOCITY_MODE, 0, SpindleState::Velocity)]
    {
        let mut bench = Bench::in_drive().before_to_velocity();
        bench.display = Some(POSITION_MODE);
        assert_eq!(bench.cycles(MODE_CYCLES - 1).error_id, 0);
        bench.v = f64::NAN;
        assert_eq!(bench.cycles(3).error_id, 14);
        (bench.v, bench.display) = (1000.0 * RPM, Some(display));
        assert_eq!((bench.cycle().error_id, bench.next()), (error, next));
    }
}

#[test]
fn to_velocity_at_half_a_turn_a_cycle_is_error_44_before_its_answer() {
    let mut bench = Bench::in_drive().before_to_velocity();
    (bench.v, bench.display) = (15_000.0 * RPM, Some(VELOCITY_MODE));
    assert_eq!((bench.cycle().error_id, bench.next()), (44, SpindleState::ToVelocity));
}

#[test]
fn velocity_puts_out_the_interpolators_velocity_and_the_actual_position() {
    for bench in Bench::both() {
        let mut bench = bench.fast(1000.0 * RPM);
        (bench.v, bench.x_actual) = (-777.0 * RPM, Some(-3.0));
        let o = bench.cycle();
        assert_eq!((o.v_spindle, o.x_spindle), (-777.0 * RPM, 359_997.0));
        assert_eq!((o.operation_mode, o.loop_closed), (bench.coeffs.velocity_mode, false));
    }
}

/// The position controller's command is none of its inputs; the interpolator's position is not looked at.
#[test]
fn velocity_does_not_look_at_the_position_command() {
    for x in [f64::NAN, 0.0, 90_000.0] {
        let mut bench = Bench::in_drive().fast(1000.0 * RPM);
        (bench.x_command, bench.x_actual) = (Some(x), Some(1.0));
        let o = bench.cycle();
        assert_eq!((o.x_spindle, o.v_spindle, o.error_id), (1.0, 1000.0 * RPM, 0));
    }
}

#[test]
fn velocity_without_an_actual_position_goes_on_from_its_own_without_an_error() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.x_actual = Some(f64::NAN);
    let (old, o) = (bench.outputs, bench.cycle());
    assert_angle(o.x_spindle, wrap(old.x_spindle + o.v_spindle * T));
    assert_eq!(o.error_id, 0);
}

#[test]
fn velocity_without_the_interpolators_velocity_goes_on_with_error_14_and_the_fourth_stops() {
    for bench in Bench::both() {
        let mut bench = bench.fast(1000.0 * RPM);
        bench.v = f64::NAN;
        let o = bench.cycles(3);
        assert_eq!((o.error_id, o.v_spindle, bench.next()), (14, 1000.0 * RPM, SpindleState::Velocity));
        let o = bench.cycle();
        assert_eq!((o.error_id, o.v_spindle, o.job), (14, 1000.0 * RPM - V_STEP, Job::Stop));
        bench.v = 1000.0 * RPM;
        assert_eq!(bench.cycle().error_id, 14, "it stays");
    }
}

#[test]
fn velocity_has_no_limit_of_half_a_turn() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.v = 20_000.0 * RPM;
    let o = bench.cycles(3);
    assert_eq!((o.error_id, o.v_spindle), (0, 20_000.0 * RPM));
}

#[test]
fn velocity_in_another_mode_is_a_missing_sample_with_error_45_and_the_fourth_stops() {
    for display in [POSITION_MODE, 0] {
        let mut bench = Bench::in_drive().fast(1000.0 * RPM);
        (bench.v, bench.x_actual, bench.display) = (500.0 * RPM, Some(1.0), Some(display));
        for _ in 0..3 {
            let (old, o) = (bench.outputs, bench.cycle());
            assert_eq!((o.error_id, o.job, o.v_spindle), (45, Job::Turn, 1000.0 * RPM));
            assert_angle(o.x_spindle, wrap(old.x_spindle + o.v_spindle * T));
        }
        let o = bench.cycle();
        assert_eq!((o.error_id, o.job, o.v_spindle), (45, Job::Stop, 1000.0 * RPM - V_STEP));
        assert_eq!((o.spindle_state, o.operation_mode), (SpindleState::Velocity, VELOCITY_MODE));
        bench.display = None;
        assert_eq!(bench.cycle().error_id, 45, "it stays");
    }
}

#[test]
fn velocity_with_a_display_again_goes_on() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.v = 500.0 * RPM;
    for _ in 0..3 {
        bench.display = Some(POSITION_MODE);
        assert_eq!(bench.cycles(3).error_id, 45);
        bench.display = None;
        let o = bench.cycle();
        assert_eq!((o.error_id, o.v_spindle), (0, 500.0 * RPM));
    }
}

#[test]
fn velocity_is_not_left_without_a_sample() {
    for bench in Bench::both() {
        let mut bench = bench.fast(1000.0 * RPM);
        bench.v = f64::NAN;
        let o = bench.with_inputs(|i| i.m19 = true);
        assert_eq!((o.error_id, o.waiting, bench.next()), (14, 1, SpindleState::Velocity));
        bench.v = 1000.0 * RPM;
        bench.cycle();
        assert_eq!(bench.next(), SpindleState::Brake);
    }
}

/// Below Voff, at Von, in the other direction.
#[test]
fn velocity_stays_for_another_speed() {
    for bench in [Bench::in_drive, Bench::in_cnc] {
        for s in [0.0, V_OFF / 2.0, 200.0 * RPM, 3000.0 * RPM] {
            let mut bench = bench().fast(1000.0 * RPM);
            bench.inputs.s_word = s;
            let o = bench.with_inputs(|i| i.m4 = true);
            assert_eq!((o.job, o.job_speed.abs()), (Job::Turn, s));
            bench.v = o.job_speed;
            assert_eq!(bench.cycles(20).spindle_state, SpindleState::Velocity);
        }
    }
}

#[test]
fn velocity_stays_for_m5() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    assert_eq!(bench.with_inputs(|i| i.m5 = true).job, Job::Stop);
    bench.v = 0.0;
    let o = bench.cycles(20);
    assert_eq!((o.spindle_state, o.operation_mode, o.job), (SpindleState::Velocity, VELOCITY_MODE, Job::Stop));
}

/// The request waits, STOP is the job until POSITION.
fn assert_brakes(ask: fn(&mut Inputs<f64>), job: Job) {
    for bench in Bench::both() {
        let mut bench = bench.fast(1000.0 * RPM);
        let o = bench.with_inputs(ask);
        assert_eq!(
            (o.spindle_state, o.v_spindle, bench.next()),
            (SpindleState::Velocity, bench.v, SpindleState::Brake)
        );
        let waiting = u32::from(job != Job::Stop);
        assert_eq!((o.job, o.waiting), (Job::Stop, waiting));
        let o = bench.cycle();
        assert_eq!((o.spindle_state, o.job, o.waiting), (SpindleState::Brake, Job::Stop, waiting));
        bench.until(SpindleState::ToPosition);
        bench.until_next(SpindleState::Position);
        assert_eq!((bench.outputs.job, bench.outputs.waiting), (job, 0), "begun in the cycle that POSITION follows");
    }
}

#[test]
fn velocity_to_brake_for_what_needs_position_control_and_for_a_reset() {
    assert_brakes(|i| i.m19 = true, Job::Orient);
    assert_brakes(|i| i.g74 = true, Job::Home);
    assert_brakes(|i| i.putax = true, Job::Release);
    assert_brakes(|i| i.reset = true, Job::Stop);
}

/// Requests in front of it are served first, one a cycle.
#[test]
fn velocity_to_brake_when_the_request_is_the_first() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    bench.with_inputs(|i| i.m5 = true);
    assert_eq!(bench.with_inputs(|i| i.m19 = true).waiting, 2);
    bench.display = Some(VELOCITY_MODE);
    let o = bench.cycle();
    assert_eq!((o.job, o.waiting, bench.next()), (Job::Stop, 1, SpindleState::Velocity));
    assert_eq!((bench.cycle().waiting, bench.next()), (1, SpindleState::Brake));
}
