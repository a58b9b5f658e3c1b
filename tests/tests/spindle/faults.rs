//! Errors that stay: what they do, how long they stay, and what a reset makes of them.

use super::bench::{BRAKE_CYCLES, Bench, MODE_CYCLES, POSITION_MODE, RPM, T, V_OFF, V_STEP, VELOCITY_MODE, wrap};
use reference::spindle::{Inputs, Job, SpindleState};

/// A bench in each error: the id, the state in which it came, and the bench after that cycle.
fn failed() -> Vec<(u32, SpindleState, Bench)> {
    let fail = |mut bench: Bench, display, cycles| {
        bench.display = display;
        bench.cycles(cycles);
        bench.display = None;
        bench
    };
    let mut half_turn = Bench::in_drive().before_to_velocity();
    half_turn.v = 15_000.0 * RPM;
    half_turn.cycle();
    let mut takeover = Bench::in_drive().before_takeover();
    takeover.x_command = Some(takeover.outputs.x_spindle + 90_000.0);
    takeover.cycle();
    let mut brake = Bench::in_drive().before_brake(1000.0 * RPM);
    brake.v_actual = Some(1e9);
    brake.cycles(BRAKE_CYCLES + 1);
    brake.v_actual = None;
    let mut benches = vec![
        (
            41,
            SpindleState::ToVelocity,
            fail(Bench::in_drive().before_to_velocity(), Some(POSITION_MODE), MODE_CYCLES + 1),
        ),
        (42, SpindleState::Brake, brake),
        (
            43,
            SpindleState::ToPosition,
            fail(Bench::in_drive().before_to_position(), Some(VELOCITY_MODE), MODE_CYCLES + 1),
        ),
        (44, SpindleState::ToVelocity, half_turn),
        (45, SpindleState::Position, fail(Bench::in_drive().before_takeover(), Some(VELOCITY_MODE), 4)),
        (45, SpindleState::Velocity, fail(Bench::in_drive().fast(1000.0 * RPM), Some(POSITION_MODE), 4)),
        (46, SpindleState::Position, takeover),
    ];
    for (state, at) in [
        (SpindleState::Position, Bench::before_takeover as fn(Bench) -> Bench),
        (SpindleState::ToVelocity, Bench::before_to_velocity),
        (SpindleState::Velocity, |bench| bench.fast(1000.0 * RPM)),
    ] {
        let mut blind = at(Bench::in_drive());
        blind.v = f64::NAN;
        benches.push((14, state, fail(blind, None, 4)));
        let mut wrong = at(Bench::in_drive());
        wrong.with_inputs(|i| i.task_cycle_ns = 1);
        benches.push((1, state, wrong));
        if state != SpindleState::Velocity {
            let mut blind = at(Bench::in_drive());
            blind.x_command = Some(f64::NAN);
            benches.push((17, state, fail(blind, None, 4)));
        }
    }
    for (id, state, bench) in &mut benches {
        assert_eq!((bench.outputs.error_id, bench.outputs.spindle_state), (*id, *state));
        (bench.v, bench.x_command) = (0.0, None);
    }
    benches
}

#[test]
fn an_error_stops_the_spindle_by_the_deceleration_in_its_state_and_mode() {
    for (id, state, mut bench) in failed() {
        let mode = bench.outputs.operation_mode;
        for _ in 0..200 {
            let (old, o) = (bench.outputs, bench.cycle());
            assert_eq!((o.error_id, o.fault, o.loop_closed), (id, true, false));
            assert_eq!((o.spindle_state, o.operation_mode, o.job), (state, mode, Job::Stop));
            assert_eq!(o.v_spindle, (old.v_spindle - V_STEP).max(0.0));
            assert_eq!(o.x_spindle, wrap(old.x_spindle + o.v_spindle * T));
        }
        assert_eq!(bench.outputs.v_spindle, 0.0);
    }
}

#[test]
fn an_error_stays_and_nothing_is_served() {
    for (id, _, mut bench) in failed() {
        let waiting = bench.outputs.waiting;
        let o = bench.with_inputs(|i| i.m5 = true);
        assert_eq!((o.error_id, o.waiting), (id, waiting + 1));
        let o = bench.cycles(100);
        assert_eq!((o.error_id, o.waiting, o.job), (id, waiting + 1, Job::Stop));
    }
}

#[test]
fn a_reset_ends_an_error_and_brakes_in_the_same_cycle() {
    for (id, _, mut bench) in failed() {
        let (old, o) = (bench.outputs, bench.with_inputs(|i| i.reset = true));
        assert_eq!((o.error_id, o.spindle_state, o.waiting), (0, SpindleState::Brake, 0), "{id}");
        let slower = if old.v_spindle > V_OFF { (old.v_spindle - V_STEP).max(V_OFF) } else { old.v_spindle };
        assert_eq!((o.v_spindle, o.operation_mode), (slower, old.operation_mode), "{id}");
        assert_eq!(bench.next(), SpindleState::Brake);
    }
}

#[test]
fn a_reset_of_an_error_leads_back_to_position() {
    for (id, _, mut bench) in failed() {
        bench.with_inputs(|i| i.reset = true);
        bench.until_next(SpindleState::Position);
        bench.v = bench.outputs.v_spindle;
        assert_eq!((bench.cycle().error_id, bench.outputs.job), (0, Job::Stop), "{id}");
    }
}

#[test]
fn a_reset_of_an_error_with_the_drive_off_clears_it_without_brake() {
    for (id, _, mut bench) in failed() {
        bench.v_actual = Some(0.0);
        let o = bench.with_inputs(|i| (i.reset, i.drive_on) = (true, false));
        assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (0, SpindleState::ToPosition, 0.0), "{id}");
        assert_eq!(bench.cycles(2).spindle_state, SpindleState::ToPosition, "{id}");
        assert_eq!(bench.cycle().spindle_state, SpindleState::Position, "{id}");
    }
}

#[test]
fn a_reset_of_an_error_that_outlasted_drive_off_begins_anew_when_the_drive_is_on() {
    for (id, _, mut bench) in failed() {
        bench.v_actual = Some(0.0);
        assert_eq!(bench.with_inputs(|i| i.drive_on = false).error_id, id);
        let o = bench.with_inputs(|i| i.reset = true);
        assert_eq!((o.error_id, o.spindle_state, o.v_spindle), (0, SpindleState::ToPosition, 0.0), "{id}");
        assert_eq!((bench.cycles(2).error_id, bench.next()), (0, SpindleState::Position), "{id}");
    }
}

/// The position command after an error: a resynchronisation like any other.
#[test]
fn brake_behind_an_error_ends_with_the_formula() {
    for (id, _, mut bench) in failed() {
        bench.with_inputs(|i| i.reset = true);
        bench.x_actual = Some(77_000.0);
        bench.until_next(SpindleState::ToPosition);
        let o = bench.cycle();
        let x = wrap(77_000.0 + o.v_spindle * bench.coeffs.lead_time);
        assert_eq!((o.spindle_state, o.x_spindle), (SpindleState::ToPosition, x), "{id}");
    }
}

#[test]
fn a_wrong_cycle_replaces_no_error_that_stays() {
    for (id, _, mut bench) in failed() {
        assert_eq!(bench.with_inputs(|i| i.task_cycle_ns = 1_000_000).error_id, id);
        assert_eq!(bench.cycle().error_id, id);
    }
}

/// The error that stays, else that of a sample, else that of a request.
#[test]
fn the_error_of_a_request_is_shown_behind_all_others() {
    for (id, _, mut bench) in failed() {
        assert_eq!(bench.with_inputs(|i| (i.m3, i.m4) = (true, true)).error_id, id);
    }
    let mut bench = Bench::in_drive().at_rest();
    bench.v = f64::NAN;
    assert_eq!(bench.with_inputs(|i| (i.m3, i.m4) = (true, true)).error_id, 14);
    bench.v = 0.0;
    bench.cycle();
    assert_eq!(bench.with_inputs(|i| (i.m3, i.m4) = (true, true)).error_id, 32);
    bench.x_actual = Some(f64::NAN);
    let off = |i: &mut Inputs<f64>| (i.drive_on, i.m5) = (false, true);
    assert_eq!(bench.with_inputs(off).error_id, 18);
}
