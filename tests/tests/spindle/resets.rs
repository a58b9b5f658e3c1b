//! Resets: one wins against everything else.

use super::bench::{Bench, MODE_CYCLES, POSITION_MODE, RPM, V_STEP, VELOCITY_MODE};
use super::start::STATES;
use reference::spindle::{Inputs, Job, SpindleState};

/// From POSITION on, a turn that is asked for then is not ended by anything older.
fn assert_turns_for_good(mut bench: Bench) {
    bench.until_next(SpindleState::Position);
    bench.v = bench.outputs.v_spindle;
    bench.cycle();
    bench.with_inputs(|i| i.m3 = true);
    bench.v = 1000.0 * RPM;
    bench.until(SpindleState::Velocity);
    let o = bench.cycles(5);
    assert_eq!((o.spindle_state, o.job), (SpindleState::Velocity, Job::Turn));
}

#[test]
fn a_reset_clears_what_waits_and_makes_stop_the_job_in_its_cycle() {
    for (_, state) in &STATES[1..] {
        for bench in Bench::both() {
            let o = state(bench).with_inputs(|i| (i.reset, i.job_done) = (true, true));
            assert_eq!((o.waiting, o.job, o.job_speed, o.job_position), (0, Job::Stop, 0.0, 0.0));
        }
    }
}

#[test]
fn no_request_counts_during_a_reset() {
    let mut bench = Bench::in_drive().at_rest();
    bench.inputs.reset = true;
    let o = bench.with_inputs(|i| (i.m3, i.m19) = (true, true));
    assert_eq!((o.waiting, o.job, o.error_id), (0, Job::Stop, 0));
    bench.inputs.m3 = true;
    bench.cycle();
    bench.inputs.reset = false;
    assert_eq!(bench.cycle().job, Job::Stop, "m3 has been TRUE since");
}

#[test]
fn a_reset_in_position_stays_there() {
    let mut bench = Bench::in_drive().turning();
    let o = bench.with_inputs(|i| i.reset = true);
    assert_eq!((o.spindle_state, o.job, bench.next()), (SpindleState::Position, Job::Stop, SpindleState::Position));
}

#[test]
fn a_reset_in_the_cycle_that_would_leave_position_stays_there() {
    for bench in Bench::both() {
        let mut bench = bench.turning();
        bench.v = 1000.0 * RPM;
        bench.with_inputs(|i| i.reset = true);
        assert_eq!(bench.next(), SpindleState::Position);
    }
}

#[test]
fn a_reset_in_to_velocity_waits_for_the_drive_and_then_brakes() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    bench.cycle();
    let o = bench.with_inputs(|i| i.reset = true);
    assert_eq!((o.spindle_state, o.operation_mode, o.job), (SpindleState::ToVelocity, VELOCITY_MODE, Job::Stop));
    bench.display = Some(VELOCITY_MODE);
    bench.cycle();
    assert_eq!((bench.cycle().spindle_state, bench.next()), (SpindleState::Velocity, SpindleState::Brake));
}

#[test]
fn a_reset_in_velocity_with_another_request_brakes_and_forgets_it() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    let o = bench.with_inputs(|i| (i.reset, i.m3, i.g74) = (true, true, true));
    assert_eq!((o.job, o.waiting, bench.next()), (Job::Stop, 0, SpindleState::Brake));
}

#[test]
fn a_reset_in_brake_and_to_position_goes_on() {
    let mut bench = Bench::in_drive().before_brake(1000.0 * RPM);
    let o = bench.with_inputs(|i| i.reset = true);
    assert_eq!((o.spindle_state, o.v_spindle), (SpindleState::Brake, 1000.0 * RPM - V_STEP));
    let mut bench = Bench::in_drive().before_to_position();
    bench.display = Some(VELOCITY_MODE);
    assert_eq!(bench.with_inputs(|i| i.reset = true).spindle_state, SpindleState::ToPosition);
    assert_eq!(bench.cycle().spindle_state, SpindleState::ToPosition);
}

#[test]
fn a_turn_during_brake_behind_a_reset_is_served() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.with_inputs(|i| i.reset = true);
    bench.with_inputs(|i| i.m3 = true);
    bench.until(SpindleState::Position);
    assert_eq!((bench.outputs.job, bench.outputs.waiting), (Job::Turn, 0));
}

/// It waits until POSITION. Only a reset after it may clear it.
#[test]
fn a_turn_in_to_velocity_behind_a_reset_is_not_lost() {
    for bench in Bench::both() {
        let mut bench = bench.before_to_velocity();
        bench.display = Some(bench.coeffs.position_mode);
        // In the CNC a sample that is missing keeps the state.
        bench.v = f64::NAN;
        bench.with_inputs(|i| i.reset = true);
        bench.with_inputs(|i| (i.m3, i.s_word) = (true, 100.0 * RPM));
        (bench.v, bench.display) = (1000.0 * RPM, None);
        bench.until_next(SpindleState::Position);
        assert_eq!((bench.outputs.job, bench.outputs.job_speed), (Job::Turn, 100.0 * RPM));
    }
}

/// A reset that ends an error ends what an older one wanted.
#[test]
fn a_reset_before_an_error_does_not_end_a_later_turn() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    bench.with_inputs(|i| i.reset = true);
    assert_eq!(bench.cycles(MODE_CYCLES).error_id, 41);
    bench.display = None;
    bench.v = 0.0;
    bench.with_inputs(|i| i.reset = true);
    assert_turns_for_good(bench);
}

/// The same when the error comes in the cycle of the reset.
#[test]
fn a_reset_in_the_cycle_of_an_error_does_not_end_a_later_turn() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    bench.display = Some(POSITION_MODE);
    bench.cycles(3);
    assert_eq!(bench.with_inputs(|i| i.reset = true).error_id, 45);
    assert_eq!(bench.outputs.v_spindle, 1000.0 * RPM - V_STEP);
    bench.display = None;
    bench.with_inputs(|i| i.reset = true);
    assert_turns_for_good(bench);
}

/// The reset is a level: it ends the error of the fourth cycle without a sample, and BRAKE needs nothing of the interpolator.
#[test]
fn a_reset_in_velocity_brakes_without_an_interpolator() {
    for bench in Bench::both() {
        let mut bench = bench.fast(1000.0 * RPM);
        bench.v = f64::NAN;
        bench.inputs.reset = true;
        let o = bench.cycles(3);
        assert_eq!((o.spindle_state, o.error_id, o.v_spindle), (SpindleState::Velocity, 14, 1000.0 * RPM));
        assert_eq!(bench.cycle().v_spindle, 1000.0 * RPM - V_STEP);
        let o = bench.cycle();
        assert_eq!((o.spindle_state, o.error_id), (SpindleState::Brake, 0));
        assert_eq!(o.v_spindle, 1000.0 * RPM - 2.0 * V_STEP);
    }
}

/// A reset in VELOCITY that a missing sample delays: what is asked for after it waits for POSITION.
#[test]
fn nothing_is_served_in_velocity_while_a_reset_is_remembered() {
    for bench in Bench::both() {
        let mut bench = bench.fast(1000.0 * RPM);
        bench.v = f64::NAN;
        let o = bench.with_inputs(|i| i.reset = true);
        assert_eq!((o.job, o.error_id), (Job::Stop, 14));
        let o = bench.with_inputs(|i| (i.m4, i.s_word) = (true, 100.0 * RPM));
        assert_eq!((o.spindle_state, o.job, o.waiting), (SpindleState::Velocity, Job::Stop, 1));
        bench.v = 1000.0 * RPM;
        let o = bench.cycle();
        assert_eq!((o.job, o.waiting, bench.next()), (Job::Stop, 1, SpindleState::Brake));
        bench.until_next(SpindleState::Position);
        assert_eq!((bench.outputs.job, bench.outputs.job_speed), (Job::Turn, -100.0 * RPM));
    }
}

/// (3) is after (2): the spindle is in BRAKE, and stops there.
#[test]
fn a_reset_in_a_wrong_cycle_ends_an_error_and_error_1_stays() {
    let mut bench = Bench::in_drive().before_to_velocity();
    bench.display = Some(POSITION_MODE);
    assert_eq!(bench.cycles(MODE_CYCLES + 1).error_id, 41);
    let wrong = |i: &mut Inputs<f64>| (i.reset, i.task_cycle_ns) = (true, 1);
    let o = bench.with_inputs(wrong);
    assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (1, SpindleState::Brake, 1000.0 * RPM - 2.0 * V_STEP));
    assert_eq!((bench.cycle().error_id, bench.next()), (1, SpindleState::Brake));
}

/// BRAKE has done what the reset wanted.
#[test]
fn a_reset_in_velocity_does_not_end_a_later_turn() {
    for bench in Bench::both() {
        let mut bench = bench.fast(1000.0 * RPM);
        bench.with_inputs(|i| i.reset = true);
        assert_turns_for_good(bench);
    }
}
