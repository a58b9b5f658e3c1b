//! The figures that the documents state. No formula is here.

use super::bench::Bench;
use crate::model::spindle::motion::{near, slower, velocity_command, wrap};
use crate::model::spindle::start::{ahead, lead_time};
use crate::model::spindle::{BRAKE, Inputs, Parameters, TO_POSITION, TO_VELOCITY};

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

/// Where position control is taken up.
fn resynchronised(p: &Parameters, inputs: &Inputs, v: f64) -> f64 {
    ahead(inputs.x_actual, v, lead_time(p, inputs))
}

#[test]
fn the_change_at_10_deg_and_300_deg_per_s_begins_at_20_5_deg() {
    let inputs = Inputs { x_actual: 10_000.0, ..Inputs::START };
    assert!(is_near(resynchronised(&Parameters::example(), &inputs, 300_000.0), 20_500.0));
    let mut bench = Bench::drive().brake();
    bench.until(|out| out.spindle_state == BRAKE && out.v_spindle <= 300_000.0);
    (bench.inputs.x_actual, bench.inputs.v_actual) = (10_000.0, 300_000.0);
    // 3 cycles whose velocity before is 50 rpm.
    assert_eq!(bench.until(|out| out.spindle_state == TO_POSITION), 4);
    assert!(is_near(bench.out.x_spindle, 20_500.0), "{:?}", bench.out);
    assert!(is_near(bench.out.v_spindle, 300_000.0));
}

#[test]
fn it_is_on_the_circle_and_in_the_other_direction_too() {
    let p = Parameters::example();
    let at = |x_actual| Inputs { x_actual, ..Inputs::START };
    assert!(is_near(resynchronised(&p, &at(355_000.0), 300_000.0), 5500.0));
    assert!(is_near(resynchronised(&p, &at(10_000.0), -300_000.0), 359_500.0));
    assert!(is_near(resynchronised(&p, &at(-350_000.0), 0.0), 10_000.0));
}

#[test]
fn the_lag_at_200_rpm_is_60_deg_and_half_of_it_with_half_of_the_feedforward() {
    let lag = |w, kv: f64, v| {
        let p = Parameters { cycle: 0.0, w, kv: kv * 0.01, ..Parameters::example() };
        resynchronised(&p, &Inputs::START, v)
    };
    assert!(is_near(lag(0.0, 2000.0, 1_200_000.0), 60_000.0));
    assert!(is_near(lag(0.5, 2000.0, 1_200_000.0), 30_000.0));
    assert!(is_near(lag(0.0, 6666.0, 1_200_000.0), 1_200_000.0 / 66.66));
    assert!(is_near(lag(1.2, 2000.0, 300_000.0), 357_000.0));
}

#[test]
fn with_position_control_in_the_cnc_the_feedforward_counts_while_it_is_active() {
    let p = Parameters { in_cnc: true, feedforward: Some(0.8), cycle: 0.0, w: 7.0, ..Parameters::example() };
    let lag = |p: &Parameters, feedforward_active, feedforward_percentage| {
        let inputs = Inputs { feedforward_active, feedforward_percentage, ..Inputs::START };
        resynchronised(p, &inputs, 1_200_000.0)
    };
    assert!(is_near(lag(&p, false, 100), 60_000.0));
    assert!(is_near(lag(&p, true, 100), 12_000.0));
    assert!(is_near(lag(&p, true, 50), 36_000.0));
    assert!(is_near(lag(&p, true, 101), 12_000.0));
    assert!(is_near(lag(&p, true, -1), 60_000.0));
    let none = Parameters { feedforward: None, ..p };
    assert!(is_near(lag(&none, true, 100), 60_000.0));
}

#[test]
fn above_200_rpm_the_change_begins_and_at_200_rpm_it_does_not() {
    let changes = |s_word, v_interpolator| {
        let mut bench = Bench::drive().positioned();
        bench.inputs.v_interpolator = v_interpolator;
        bench.once(|i| (i.m4, i.s_word) = (true, s_word));
        bench.cycles(3).spindle_state != 0
    };
    assert!(!changes(1_200_000.0, 1_200_000.0));
    assert!(changes(1_200_000.1, 1_200_000.0));
    assert!(changes(1_200_000.1, -1_200_000.0));
    assert!(!changes(2_000_000.0, 1_199_999.9));
}

#[test]
fn in_the_cnc_the_delay_of_the_actual_position_does_not_count() {
    let p = Parameters { in_cnc: true, kv: 100.0, feedforward: None, ..Parameters::example() };
    // The first closed cycle at 50 rpm: Kv times the distance to the actual position of that cycle.
    let first = |p: &Parameters| p.kv * (resynchronised(p, &Inputs::START, 300_000.0) - 300_000.0 * p.cycle);
    assert!(is_near(first(&p), 300_000.0));
    assert!(is_near(first(&Parameters { nd: 9, ..p.clone() }), 300_000.0));
    assert!(is_near(first(&Parameters { in_cnc: false, w: 0.0, ..p.clone() }) - 240_000.0, 300_000.0));
    let mut bench = Bench::new(&p).brake();
    bench.inputs.v_actual = 300_000.0;
    bench.until(|out| out.spindle_state == TO_POSITION);
    assert!(is_near(bench.out.x_spindle, 100_000.0 + 3600.0), "{:?}", bench.out);
}

#[test]
fn from_200_rpm_it_brakes_to_50_rpm_in_75_cycles_and_looks_at_3() {
    let mut bench = Bench::drive().brake();
    assert!(is_near(bench.out.v_spindle, 1_788_000.0));
    let position = wrap(bench.out.x_spindle + 1_776_000.0 * 0.002);
    assert!(is_near(bench.cycle().x_spindle, position));
    bench.until(|out| out.v_spindle <= 1_200_000.0);
    assert_eq!(bench.until(|out| out.v_spindle <= 300_000.0), 75);
    assert!(is_near(bench.cycles(20).v_spindle, 300_000.0));
    // Approached from above, at the window's end.
    bench.inputs.v_actual = -303_000.0;
    bench.cycles(2);
    bench.once(|i| i.v_actual = 303_001.0);
    assert_eq!(bench.cycles(3).spindle_state, BRAKE);
    assert_eq!(bench.cycle().spindle_state, TO_POSITION);
}

#[test]
fn half_a_turn_a_cycle_is_15_000_rpm_at_2_ms_and_strictly_less_is_allowed() {
    let error = |v| Bench::drive().positioned().once(|i| i.v_interpolator = v).error_id;
    assert_eq!([error(90_000_000.0), error(-90_000_000.0), error(89_999_999.0)], [44, 44, 0]);
    let mut bench = Bench::drive().changing();
    bench.echoes = false;
    bench.inputs.operation_mode_display = 8;
    assert_eq!(bench.once(|i| i.v_interpolator = 89_999_999.0).error_id, 0);
    assert_eq!(bench.once(|i| i.v_interpolator = 90_000_000.0).error_id, 44);
    assert_eq!(bench.out.spindle_state, TO_VELOCITY);
    let mut bench = Bench::cnc().positioned();
    assert_eq!(bench.once(|i| i.v_interpolator = 90_000_000.0).error_id, 0);
    let mut bench = Bench::drive().velocity();
    assert_eq!(bench.once(|i| i.v_interpolator = 90_000_000.0).error_id, 0);
}

#[test]
fn rpm_as_process_data_round_half_away_from_zero_and_are_cut_off() {
    let p = Parameters { velocity_scale: 0.5, velocity_range: [-32_768, 32_767], ..Parameters::example() };
    let data = |v| velocity_command(&p, v);
    assert_eq!([data(1.0), data(-1.0), data(3.0), data(0.9)], [(1, false), (-1, false), (2, false), (0, false)]);
    assert_eq!([data(65_534.9), data(65_535.0)], [(32_767, false), (32_767, true)]);
    assert_eq!([data(-65_536.9), data(-65_537.0)], [(-32_768, false), (-32_768, true)]);
    assert_eq!(data(1e15), (32_767, true));
    assert_eq!(velocity_command(&Parameters::example(), 1_200_000.0), (2_000_000, false));
}

#[test]
fn angles_are_on_the_circle() {
    let wrapped = [-1e-20, -360_000.0, 360_000.0, 7e14, -7e14].map(wrap);
    assert!(wrapped.iter().all(|x| (0.0..360_000.0).contains(x)), "{wrapped:?}");
    assert!(is_near(wrap(7e14), f64::from(u32::try_from(700_000_000_000_000_u64 % 360_000).expect("small"))));
    assert!(is_near(near(180_000.0), -180_000.0) && is_near(near(-180_000.0), -180_000.0));
    assert!(is_near(near(359_000.0), -1000.0) && is_near(near(1000.0), 1000.0));
    assert!(is_near(slower(-10.0, 3.0, 5.0), -5.0) && is_near(slower(-10.0, 3.0, 50.0), -3.0));
    assert!(is_near(slower(2.0, 3.0, 5.0), 2.0) && is_near(slower(2.0, 0.0, 5.0), 0.0));
}
