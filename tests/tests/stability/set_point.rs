//! SET_POINT inside the position loop of the CNC, cycle by cycle: 3 % above the weight that the rule names the loop
//! oscillates, 3 % below it does not. The drive does what was commanded one cycle before.

use crate::random::{axis, read};
use axgen_tests::subject::Subject;
use generator::analysis::analyze;
use generator::axis::DriveModel;
use generator::blocks::Designed;
use machine::closed_loop::Signals;

/// f0 as a part of Kv [Hz s]; quality factor and damping.
const F0: [f64; 4] = [0.05, 0.1, 0.17, 0.4];
const SHAPES: [[f64; 2]; 4] = [[1.0, 0.3], [1.0, 0.9], [1.0, 0.7], [4.0, 0.6]];
/// [s]; cycles of a window
const CYCLE: f64 = 2e-3;
const WINDOW: usize = 8_000;

fn stage(mode: &str, [f0, q_factor, damping]: [f64; 3], weight: f64) -> String {
    let filter = format!("{{ order = 1, fg_f0 = {f0:.4}, q_factor = {q_factor} }}");
    let damping = if mode == "DIRECT" { String::new() } else { format!("osc_damping = {damping}, ") };
    let weight = format!("weight_fact_num = {:.0}, weight_fact_denom = 1000000", weight * 1e6);
    format!("{{ mode = \"{mode}\", {damping}{weight}, filter = [{filter}] }}")
}

/// Whether a small step of the position is followed by an oscillation that grows.
fn grows(designed: &Designed, kv: f64) -> bool {
    let (mut block, mut x, mut v_motor) = (Subject::new(designed), 0.0, 0.0);
    block.set("mode", 1.0);
    let (mut windows, mut is_limited) = ([0.0_f64; 5], false);
    for n in 0..WINDOW * windows.len() {
        let error = if n < WINDOW { 0.0 } else { 1.0 - x };
        let v_command = kv * error;
        let v_add = block.step(&Signals { v_command, v_motor, v_direct: 0.0 });
        x += v_motor * CYCLE;
        v_motor = v_command + v_add;
        windows[n / WINDOW] += error * error;
        is_limited |= block.get("limited") != 0.0;
        block.record_anew();
    }
    // Far below the step there is only rounding.
    is_limited || windows[4] > windows[2].max(1e-20)
}

#[test]
fn the_loop_oscillates_above_the_weight_of_the_rule_and_not_below() {
    let mut ends = 0;
    let all = [10.0, 30.0, 80.0].into_iter().flat_map(|kv| F0.map(|part| (kv, kv * part)));
    for ((kv, f0), [q_factor, damping]) in all.flat_map(|of| SHAPES.map(|shape| (of, shape))) {
        let second = stage("SET_POINT", [1.8 * f0, 1.0, 0.9], 0.76);
        for other in [Vec::new(), vec![second], vec![stage("DIRECT", [53.0, 10.0, 0.0], 0.5)]] {
            let with = |weight: f64| {
                let stages = [vec![stage("SET_POINT", [f0, q_factor, damping], weight)], other.clone()].concat();
                let axis = axis("X", &format!(", kv = {}", kv * 100.0), "DRYRUN", &stages);
                let (axes, report) = read(&format!("cycle_time = \"2ms\"\n{axis}"));
                (axes.unwrap_or_else(|| panic!("{report}")).remove(0), format!("{report}{axis}"))
            };
            let (designed, _) = with(1.0);
            let model = DriveModel { delay_cycles: Some(1.0), ..designed.axis.drive.clone() };
            let end = analyze(&designed, &model).drives[0].stages[0].largest_stable_weight;
            ends += u32::from(end < 7.0);
            let below = (end > 0.0).then_some((end * 0.97, false));
            let above = (end < 7.0).then_some(((end * 1.03).max(0.01), true));
            for (weight, expected) in below.into_iter().chain(above) {
                let (designed, said) = with(weight);
                let found = [said.contains("AX461"), grows(&designed, kv)];
                assert_eq!(found, [expected; 2], "{weight} of {end}: {said}");
            }
        }
    }
    assert!(ends > 50, "weights that end below 7: {ends}");
}
