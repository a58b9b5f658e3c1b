//! Numbers that the manual and the page state, in degrees and rpm.

use super::bench::{Bench, RPM, T, V_OFF, V_ON, assert_angle, wrap};
use reference::spindle::{Coeffs, SpindleState};
use std::collections::VecDeque;

/// Where position control is taken up [deg] from an actual position [deg] at a velocity [deg/s], with this lead time.
fn resynchronised(x: f64, v: f64, lead_time: f64) -> f64 {
    let coeffs = Coeffs {
        lead_time,
        v_position_control_on: 1e9,
        v_position_control_on_negative: -1e9,
        ..Bench::in_drive().coeffs
    };
    let mut bench = Bench::with(coeffs).before_brake(v * 1000.0);
    bench.x_actual = Some(x * 1000.0);
    bench.until(SpindleState::ToPosition).x_spindle / 1000.0
}

/// (Nd + 1) T + (1 - w) / Kv.
fn lead_time(nd: f64, t: f64, w: f64, kv: f64) -> f64 {
    (nd + 1.0) * t + (1.0 - w) / kv
}

/// 10 deg, 300 deg/s, Kv 20/s, Nd 4, T 2 ms, w 0.5.
#[test]
fn the_example_is_resynchronised_at_20_5_deg() {
    assert_angle(1000.0 * resynchronised(10.0, 300.0, lead_time(4.0, 0.002, 0.5, 20.0)), 20_500.0);
    // In the other direction, and across the turn.
    assert_angle(1000.0 * resynchronised(10.0, -300.0, lead_time(4.0, 0.002, 0.5, 20.0)), 359_500.0);
    assert_angle(1000.0 * resynchronised(355.0, 300.0, lead_time(4.0, 0.002, 0.5, 20.0)), 5500.0);
}

/// 1200 deg/s, Kv 20/s, without dead time.
#[test]
fn the_lag_at_200_rpm_is_60_deg_and_with_half_of_the_feedforward_30_deg() {
    let v = V_ON / 1000.0;
    assert_eq!(v, 1200.0);
    assert_angle(1000.0 * resynchronised(0.0, v, lead_time(-1.0, T, 0.0, 20.0)), 60_000.0);
    assert_angle(1000.0 * resynchronised(0.0, v, lead_time(-1.0, T, 0.5, 20.0)), 30_000.0);
    assert_angle(1000.0 * resynchronised(0.0, v, lead_time(-1.0, T, 1.0, 20.0)), 0.0);
}

/// With position control in the CNC: Kv 20/s, all of the feedforward of the velocity, by G135 and G136.
#[test]
fn the_lag_in_the_cnc_is_60_deg_without_feedforward_and_30_deg_with_50_percent() {
    for (is_active, is_default, percentage, lag) in [
        (false, false, 100, 60_000.0),
        (true, false, 50, 30_000.0),
        (true, false, 100, 0.0),
        (true, false, 200, 0.0),
        (true, false, -1, 60_000.0),
        (false, true, 50, 30_000.0),
    ] {
        let coeffs = Coeffs {
            lead_time: 1.0 / 20.0,
            default_active: is_default,
            v_position_control_on: V_ON,
            ..Bench::in_cnc().coeffs
        };
        let mut bench = Bench::with(coeffs);
        bench.inputs.feedforward_active = is_active;
        bench.inputs.feedforward_percentage = percentage;
        let mut bench = bench.before_brake(V_ON);
        bench.x_actual = Some(0.0);
        assert_angle(bench.until(SpindleState::ToPosition).x_spindle, lag);
    }
}

/// 180 deg in 2 ms: 15 000 rpm are too fast already, the next number below is not.
#[test]
fn half_a_turn_a_cycle_of_2_ms_is_15_000_rpm_and_too_fast() {
    let limit = 15_000.0 * RPM;
    assert_eq!(limit * T, 180_000.0);
    let error = |bench: Bench, v: f64| {
        let mut bench = bench;
        bench.v = v;
        bench.cycle().error_id
    };
    for v in [limit, -limit] {
        assert_eq!(error(Bench::in_drive().turning(), v), 44);
        assert_eq!(error(Bench::in_drive().before_to_velocity(), v), 44);
        assert_eq!(error(Bench::in_cnc().turning(), v), 0, "the CNC counts turns");
    }
    for v in [limit.next_down(), -limit.next_down()] {
        assert_eq!(error(Bench::in_drive().turning(), v), 0);
        assert_eq!(error(Bench::in_drive().before_to_velocity(), v), 0);
    }
}

/// The reason for the formula, by a drive that is none of the block's: Kv 20/s, feedforward 0.5, the command 2 cycles on its
/// way there, the actual value 2 on its way back (Nd 4). Without a jerk the drive goes on at the velocity that it has.
#[test]
fn a_drive_that_takes_up_position_control_by_the_formula_keeps_its_velocity() {
    const KV: f64 = 20.0;
    const W: f64 = 0.5;
    for v in [V_OFF, -V_OFF, 20.0 * RPM] {
        let coeffs = Coeffs { mode_cycles: 100, ..Bench::in_drive().coeffs };
        let mut bench = Bench::with(coeffs).before_brake(v);
        let (mut x, mut is_position) = (wrap(bench.outputs.x_spindle), false);
        let mut there = VecDeque::from([bench.outputs; 2]);
        let mut back = VecDeque::from([(x - 2.0 * v * T, v), (x - v * T, v), (x, v)]);
        for _ in 0..100 {
            // What is seen is where the drive was 2 cycles ago; what is put out arrives 2 cycles later.
            let (x_seen, v_seen) = back.pop_front().expect("three");
            (bench.x_actual, bench.v_actual, bench.v) = (Some(x_seen), Some(v_seen), v);
            bench.display = Some(bench.outputs.operation_mode);
            there.push_back(bench.cycle());
            assert_eq!(bench.outputs.error_id, 0);
            let command = there.pop_front().expect("three");
            is_position |= command.spindle_state == SpindleState::Position;
            is_position |= command.spindle_state == SpindleState::ToPosition;
            let lag = wrap(command.x_spindle - x + 180_000.0) - 180_000.0;
            let v_drive = if is_position { KV * lag + W * command.v_spindle } else { command.v_spindle };
            assert!((v_drive - v).abs() < 1e-3 * v.abs(), "{v_drive} instead of {v}, {command:?}");
            x = wrap(x + v_drive * T);
            back.push_back((x, v_drive));
        }
        assert!(is_position, "{:?}", bench.outputs);
    }
}

/// With position control in the CNC: 50 rpm, Kv 100/s, T 2 ms, Nd 4. The drive goes on at 300 deg/s.
#[test]
fn the_first_closed_cycle_in_the_cnc_asks_for_300_deg_per_s_and_with_nd_in_the_formula_for_540() {
    const KV: f64 = 100.0;
    for (lead_time, expected) in [(T + 1.0 / KV, 300_000.0), (lead_time(4.0, T, 0.0, KV), 540_000.0)] {
        let coeffs = Coeffs { lead_time, has_feedforward: false, ..Bench::in_cnc().coeffs };
        let mut bench = Bench::with(coeffs).before_brake(V_OFF);
        let mut x_actual = 10_000.0;
        while bench.outputs.spindle_state != SpindleState::ToPosition {
            x_actual += V_OFF * T;
            bench.x_actual = Some(x_actual);
            bench.cycle();
        }
        let lag = wrap(bench.outputs.x_spindle - x_actual + 180_000.0) - 180_000.0;
        assert!((KV * lag - expected).abs() < 1e-3, "{lag}");
    }
}

/// The number of turns must fit an integer of 32 bits.
#[test]
fn x_spindle_is_within_a_turn_at_the_limits_of_all_samples() {
    for sign in [1.0, -1.0] {
        let mut bench = Bench::in_cnc().at_rest();
        bench.x_command = Some(sign * 7e14);
        let mut found = vec![bench.cycle()];
        let mut bench = Bench::in_drive().fast(sign * 1e15);
        bench.x_actual = Some(sign * 7e14);
        found.push(bench.cycle());
        bench.x_actual = Some(f64::NAN);
        found.push(bench.cycle());
        let mut bench = Bench::in_drive().before_brake(sign * 1e15);
        found.push(bench.cycle());
        let mut bench = Bench::in_drive().before_brake(sign * V_OFF);
        bench.x_actual = Some(sign * 7e14);
        found.extend([bench.until(SpindleState::ToPosition), bench.cycle()]);
        for o in found {
            assert!((0.0..360_000.0).contains(&o.x_spindle) && o.error_id == 0, "{o:?}");
        }
    }
}
