//! Warnings about what turns the phase of a stage: the delay, the load, an all-pass.

use super::{IPC, read_list, set_point};
use generator::summary;

/// What `check` says of a SET_POINT stage: the rest of the command at f0, and the rest where v_add comes a cycle late. By
/// the formula of the simulated oscillation at its own frequency, where the band-pass is 1: H = -w (1 - j / (2 D)), late H
/// e^(-j 2 pi f0 Ts).
#[test]
fn a_set_point_stage_whose_addition_comes_late() {
    let (damping, weight, cycle) = (0.3f64, 0.26f64, 1e-3f64);
    for (f0, expected) in
        [(11.0f64, "86 % | 89 % | 4 deg"), (100.0, "86 % | 116 % | 36 deg"), (200.0, "86 % | 139 % | 72 deg")]
    {
        let turn = std::f64::consts::TAU * f0 * cycle;
        let left = |turn: f64| {
            // -w (1 - j / (2 D)) (cos - j sin)
            let (sine, cosine) = turn.sin_cos();
            let (re, im) = (-weight * (cosine - sine / (2.0 * damping)), weight * (sine + cosine / (2.0 * damping)));
            ((1.0 + re).hypot(im) * 100.0).round()
        };
        let list = set_point(&format!(
            "ipc.stage[0].osc_damping {damping}\nipc.stage[0].weight_fact_num 26\nipc.stage[0].weight_fact_denom 100\n\
             ipc.stage[0].filter.fg_f0 {f0}"
        ));
        let (set, report) = read_list(list.replace("ipc.", IPC));
        let set = set.unwrap_or_else(|| panic!("{report}"));
        let text = summary::details(&set.axes[0]).text();
        let degrees = (360.0 * f0 * cycle * 10.0).round() / 10.0;
        let [left, late] = [left(0.0), left(turn)];
        assert_eq!(format!("{left} % | {late} % | {} deg", degrees.round()), expected);
        let late =
            format!("{late} % where the drive gets v_add a cycle late, which turns it by 360 f0 Ts = {degrees} deg");
        assert!(text.contains(&format!("{left} % of it pass at {f0} Hz; {late}\n")), "{late}\n{text}");
    }
}
