//! Errors that stay: what they do, how long they stay, and what a reset makes of them.

use super::bench::{Bench, LEAD_TIME, POSITION_MODE, T, V_OFF, V_STEP, wrap};
use super::script;
use reference::spindle::{Inputs, Job, SpindleState};

/// Where each error comes: the id, the state in which it comes, and the script that leads there.
const ERRORS: [(u32, SpindleState, &str); 15] = [
    (41, SpindleState::ToVelocity, "from ToVelocity: display=8, x6"),
    (42, SpindleState::Brake, "from Brake 1000: v_actual=200000, x121"),
    (43, SpindleState::ToPosition, "from ToPosition: display=9, x6"),
    (44, SpindleState::ToVelocity, "from ToVelocity: v=15000"),
    (45, SpindleState::Position, "from takeover: display=9, x4"),
    (45, SpindleState::Velocity, "from Velocity 1000: display=8, x4"),
    (46, SpindleState::Position, "from takeover: x_off=90"),
    (14, SpindleState::Position, "from takeover: v=NaN, x4"),
    (14, SpindleState::ToVelocity, "from ToVelocity: v=NaN, x4"),
    (14, SpindleState::Velocity, "from Velocity 1000: v=NaN, x4"),
    (17, SpindleState::Position, "from takeover: x_command=NaN, x4"),
    (17, SpindleState::ToVelocity, "from ToVelocity: x_command=NaN, x4"),
    (1, SpindleState::Position, "from takeover: wrong_cycle"),
    (1, SpindleState::ToVelocity, "from ToVelocity: wrong_cycle"),
    (1, SpindleState::Velocity, "from Velocity 1000: wrong_cycle"),
];

/// A bench in each error, with samples again.
fn failed() -> Vec<(u32, SpindleState, Bench)> {
    let fail = |(id, state, script)| {
        let mut bench = script::bench(script);
        assert_eq!((bench.outputs.error_id, bench.outputs.spindle_state), (id, state));
        (bench.v, bench.x_command, bench.v_actual, bench.display) = (0.0, None, None, None);
        (id, state, bench)
    };
    ERRORS.into_iter().map(fail).collect()
}

#[test]
fn an_error_stops_the_spindle_by_the_deceleration_in_its_state_and_mode() {
    for (id, state, mut bench) in failed() {
        let mode = bench.outputs.operation_mode;
        let lead = if mode == POSITION_MODE { T } else { LEAD_TIME - T };
        for _ in 0..200 {
            let (old, o) = (bench.outputs, bench.cycle());
            assert_eq!((o.error_id, o.fault, o.loop_closed), (id, true, false));
            assert_eq!((o.spindle_state, o.operation_mode, o.job), (state, mode, Job::Stop));
            assert_eq!(o.v_spindle, (old.v_spindle - V_STEP).max(0.0));
            assert_eq!(o.x_spindle, wrap(old.x_spindle + o.v_spindle * lead));
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
