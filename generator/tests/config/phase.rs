//! Warnings about what turns the phase of a stage: the delay, the load, an all-pass.

use super::{IPC, assert_said, assert_transcript, direct, indirect, read_list, said, said_of_axis, set_point};
use generator::summary;

#[test]
fn v_direct() {
    assert_said(
        &said_of_axis(
            "ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', direct_source = 'v_direct', filter = [{ order = 1, fg_f0 = 20, q_factor = 2 }] }]",
        ),
        &[
            "set.toml:4:80: warning[AX406]: stage[0] feeds back v_direct, which lags by the drive, the mechanics and the delay: beyond 90 degrees at f0 an all-pass is mandatory, or the loop is unstable",
            "    write instead: an ALLPASS in filter[1], and a weight of at most 1",
        ],
    );
}

#[test]
fn v_direct_with_an_allpass_and_a_weight_of_1() {
    assert_said(
        &said_of_axis(
            "ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', direct_source = 'v_direct', filter = [{ order = 1, fg_f0 = 20, q_factor = 2 }, { type = 'ALLPASS', fg_f0 = 15, q_factor = 2 }] }]",
        ),
        &[],
    );
}

#[test]
fn v_direct_with_an_allpass_and_a_larger_weight() {
    assert_said(
        &said_of_axis(
            "ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', direct_source = 'v_direct', weight_fact_num = 2, weight_fact_denom = 1, filter = [{ order = 1, fg_f0 = 20, q_factor = 2 }, { type = 'ALLPASS', fg_f0 = 15, q_factor = 2 }] }]",
        ),
        &[
            "set.toml:4:80: warning[AX406]: stage[0] feeds back v_direct, which lags by the drive, the mechanics and the delay: beyond 90 degrees at f0 an all-pass is mandatory, or the loop is unstable",
            "    write instead: a weight of at most 1",
        ],
    );
}

#[test]
fn delay() {
    assert_said(&said(&direct("ipc.stage[0].filter.fg_f0 111")), &[]);
    assert_said(
        &said(&direct("ipc.stage[0].filter.fg_f0 112")),
        &[
            "x.lis:1:58: warning[AX408]: stage[0] at 112 Hz: the delay of the loop alone, 1.5 cycles at the least, costs 60.48 degrees; beyond 90 degrees in all it excites what it is to damp",
            "    write instead: an ALLPASS in the other filter, SET_POINT, or a shorter cycle time",
        ],
    );
}

#[test]
fn delay_with_an_allpass_or_without_a_loop() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter.fg_f0 200\n\
             ipc.stage[0].filter[1].type ALLPASS\n\
             ipc.stage[0].filter[1].fg_f0 180\n\
             ipc.stage[0].filter[1].q_factor 2",
        )),
        &[],
    );
}

#[test]
fn allpass_at_the_f0_of_the_bandpass() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter[1].type ALLPASS\n\
             ipc.stage[0].filter[1].fg_f0 53\n\
             ipc.stage[0].filter[1].q_factor 2",
        )),
        &[
            "x.lis:2:61: warning[AX410]: stage[0].filter[1] is an all-pass at the f0 of the band-pass: it inverts the stage's polarity",
            "    write instead: an fg_f0 farther from it, unless the inversion is meant",
        ],
    );
}

/// Nearly at the frequency of the band-pass it inverts too; where it leads by 120 degrees it does not.
#[test]
fn allpass_near_the_f0_of_the_bandpass() {
    let say = |f0: &str| {
        let allpass =
            "ipc.stage[0].filter[1].type ALLPASS\nipc.stage[0].filter[1].q_factor 2\nipc.stage[0].filter[1].fg_f0";
        said(&direct(&format!("ipc.stage[0].filter.fg_f0 40\n{allpass} {f0}")))
    };
    assert_transcript(
        say,
        r"
> 40.001
x.lis:4:61: warning[AX410]: stage[0].filter[1] is an all-pass that turns by -179.989 degrees at the f0 of the band-pass: it inverts the stage's polarity
    write instead: an fg_f0 farther from it, unless the inversion is meant

> 41

> 34.64
",
    );
}

/// The cycles that the list has (P-AXIS-00191) take the place of the one that it takes at the least.
#[test]
fn delay_of_as_many_cycles_as_the_list_has() {
    assert_transcript(
        |given| said(&direct(&format!("ipc.stage[0].filter.fg_f0 60\n{given}"))),
        r"
> antr.nbr_delay_cycles 9
x.lis:1:58: warning[AX408]: stage[0] at 60 Hz: the delay of the loop alone, 9 cycles (P-AXIS-00191) and half a cycle of the hold, costs 205.2 degrees; beyond 90 degrees in all it excites what it is to damp
    write instead: an ALLPASS in the other filter, SET_POINT, or a shorter cycle time

> antr.nbr_delay_cycles 2

> antr.nbr_delay_cycles 0

> antr.nbr_delay_cycles 10
> ipc.stage[0].filter[1].type ALLPASS
> ipc.stage[0].filter[1].fg_f0 53
> ipc.stage[0].filter[1].q_factor 2
",
    );
}

#[test]
fn delay_of_cycles_that_do_not_exist() {
    for stage in
        [direct, |but: &str| indirect(&format!("{but}\nipc.stage[0].osc_damping 0.8"))] as [fn(&str) -> String; 2]
    {
        assert_transcript(
            |given| said(&stage(given)),
            r"
> antr.nbr_delay_cycles 11
x.lis:1:23: error[AX203]: `antr.nbr_delay_cycles` (P-AXIS-00191) is 11
    allowed: 0 <= nbr_delay_cycles <= 10 [cycles]

> antr.nbr_delay_cycles -7
x.lis:1:23: error[AX203]: `antr.nbr_delay_cycles` (P-AXIS-00191) is -7
    allowed: 0 <= nbr_delay_cycles <= 10 [cycles]

> antr.nbr_delay_cycles abc
x.lis:1:23: error[AX201]: `antr.nbr_delay_cycles` (P-AXIS-00191) is `abc`, no whole number
    allowed: a whole number, 0 <= nbr_delay_cycles <= 10 [cycles]
",
        );
    }
    assert_said(&said("antr.nbr_delay_cycles 11\ngetriebe[0].kv 2000"), &[]);
}

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
        let text = summary::verdict(&set.axes[0]);
        let degrees = (360.0 * f0 * cycle * 10.0).round() / 10.0;
        assert_eq!(format!("{} % | {} % | {} deg", left(0.0), left(turn), degrees.round()), expected);
        let line = format!(
            "  stage 0: filters the command, so that no loop can become unstable: {} % of it pass at {f0} Hz; {} % where the drive gets \
             v_add a cycle late, which turns it by 360 f0 Ts = {degrees} deg",
            left(0.0),
            left(turn)
        );
        assert!(text.lines().any(|found| found == line), "{line}\n{text}");
    }
}
