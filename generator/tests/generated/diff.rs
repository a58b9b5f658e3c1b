//! What a change between two sets means, in exact texts.

use generator::config::ListOptions;
use generator::diff::lines;
use generator::pipeline::{Set, read_to_look_at, read_with};
use std::path::Path;

const LIST: &str = include_str!("../../../examples/rack-and-pinion.lis");

/// The axis list of the example as axis X, each `from` replaced by `to`; every one must be there.
fn list(changes: &[(&str, &str)]) -> Set {
    let text = changes.iter().fold(LIST.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let options =
        ListOptions { cycle_time: Some("1ms".to_owned()), name: Some("X".to_owned()), ..ListOptions::default() };
    // What is unstable can be compared all the same.
    let (set, report) = read_to_look_at(Path::new("x.lis"), &options, &|_| Ok(text.as_bytes().to_vec()));
    set.unwrap_or_else(|| panic!("{report}"))
}

fn read(path: &Path, options: &ListOptions, text: &str) -> Set {
    let (set, report) = read_with(path, options, &|_| Ok(text.as_bytes().to_vec()));
    set.unwrap_or_else(|| panic!("{report}"))
}

fn toml(text: &str) -> Set {
    read(Path::new("x.toml"), &ListOptions::default(), text)
}

fn said(old: &Set, new: &Set) -> Vec<String> {
    let (lines, differ) = lines(&old.axes, &new.axes);
    assert_eq!(differ, lines != ["no difference in what the blocks do"]);
    lines
}

/// After `axis X: `, from the example to the example changed.
#[track_caller]
fn assert_changed(changed: &[(&str, &str)], expected: &[&str]) {
    let expected: Vec<String> = expected.iter().map(|line| format!("axis X: {line}")).collect();
    assert_eq!(said(&list(&[]), &list(changed)), expected);
}

const NONE: [&str; 1] = ["no difference in what the blocks do"];

#[test]
fn a_comment_another_order_and_parameters_of_other_functions_are_no_difference() {
    let mut reversed: Vec<&str> = LIST.lines().collect();
    reversed.reverse();
    let text = format!("# a comment\nkenngr.swe_pos 1234\n{}\n", reversed.join("\n"));
    let options =
        ListOptions { cycle_time: Some("1ms".to_owned()), name: Some("X".to_owned()), ..ListOptions::default() };
    assert_eq!(said(&list(&[]), &read(Path::new("x.lis"), &options, &text)), NONE);
}

#[test]
fn the_same_weight_written_otherwise_is_no_difference() {
    assert_eq!(
        said(
            &list(&[]),
            &list(&[
                ("weight_fact_num   300", "weight_fact_num   3"),
                ("weight_fact_denom 100", "weight_fact_denom 1"),
                ("weight_fact_num   190", "weight_fact_num   19"),
                ("stage[1].weight_fact_denom 1", "stage[1].weight_fact_denom 10")
            ])
        ),
        NONE
    );
}

/// DIRECT does not use it.
#[test]
fn a_parameter_that_the_mode_does_not_use_is_no_difference() {
    assert_eq!(said(&list(&[]), &list(&[("stage[0].filter.damping    1", "stage[0].filter.damping    0.5")])), NONE);
}

#[test]
fn another_centre_frequency() {
    assert_changed(
        &[("fg_f0      53", "fg_f0      52")],
        &["stage[0]: centre frequency 53 -> 52 Hz (-1.9 %), edges 50.41..55.71 -> 49.46..54.66 Hz; at 53 Hz: 9.54 \
             -> 8.95 dB, 180 -> 159.1 deg; at 52 Hz: 8.95 -> 9.54 dB, -159.2 -> -180 deg; slowest decay to 1/e \
             0.06005 -> 0.0612 s"],
    );
}

#[test]
fn a_tiny_change_has_as_many_digits_as_show_it() {
    assert_changed(
        &[("fg_f0      53", "fg_f0      53.00001")],
        &["stage[0]: centre frequency 53 -> 53.00001 Hz (+1.9e-5 %), edges 50.4137..55.7137 -> 50.4138..55.7138 Hz"],
    );
}

#[test]
fn another_quality_factor_and_order() {
    assert_changed(
        &[("q_factor   10", "q_factor   5"), ("stage[0].filter.order      1", "stage[0].filter.order      2")],
        &[
            "stage[0]: quality factor 10 -> 5, bandwidth 5.3 -> 10.6 Hz, edges 50.41..55.71 -> 47.95..58.55 Hz, \
             order 1 -> 2; slowest decay to 1/e 0.06005 -> 0.0193 s",
            "stage[0]: largest weight: calm (Ms <= 2) 7 -> 2.1, stable 7, with a drive that only delays 1.5 cycles",
            "stage[1]: largest weight: calm (Ms <= 2) 3.2 -> 0, stable 7, with a drive that only delays 1.5 cycles",
        ],
    );
}

#[test]
fn another_weight_and_damping() {
    assert_changed(
        &[("weight_fact_num   190", "weight_fact_num   95"), ("filter.damping    0.8", "filter.damping    0.4")],
        &[
            "stage[1]: weight 1.9 -> 0.95 (5.58 -> -0.45 dB); damping 0.8 -> 0.4; at 11 Hz: 7.01 -> 3.64 dB, 148 -> \
             128.7 deg",
            "stage[1]: largest weight: calm (Ms <= 2) 3.2 -> 1.2, stable 7 -> 4.6, with a drive that only delays 1.5 cycles",
        ],
    );
}

/// The blocks are the same, and what was asked for is not.
#[test]
fn a_weight_above_the_cap() {
    let capped = list(&[("stage[0].weight_fact_num   300", "stage[0].weight_fact_num   70000")]);
    let seven = list(&[("stage[0].weight_fact_num   300", "stage[0].weight_fact_num   700")]);
    assert_eq!(said(&capped, &seven), ["axis X: stage[0]: weight 7 (700 capped) -> 7 (16.9 -> 16.9 dB)"]);
    assert_eq!(said(&seven, &capped), ["axis X: stage[0]: weight 7 -> 7 (700 capped) (16.9 -> 16.9 dB)"]);
    assert_eq!(said(&capped, &capped), NONE);
}

#[test]
fn another_mode() {
    assert_changed(
        &[("INDIRECT", "SET_POINT")],
        &[
            "stage[1]: INDIRECT from v_motor -> SET_POINT from v_command",
            "stage[1]: largest weight: calm (Ms <= 2) 3.2 -> 5.2, stable 7, with a drive that only delays 1.5 cycles",
        ],
    );
}

#[test]
fn a_stage_that_measures_now_what_it_simulated() {
    assert_changed(
        &[("stage[1].mode              INDIRECT", "stage[1].mode              DIRECT")],
        &[
            "stage[1]: INDIRECT from v_motor -> DIRECT from v_motor; damping 0.8 -> none; at 11 Hz: 7.01 -> 5.58 \
             dB, 148 -> 180 deg",
            "stage[1]: largest weight: calm (Ms <= 2) 3.2 -> 7, stable 7, with a drive that only delays 1.5 cycles",
        ],
    );
}

#[test]
fn a_stage_that_came_or_went() {
    assert_changed(
        &[("stage[1].mode              INDIRECT", "stage[1].mode              NOT_ACTIVE")],
        &["stage[1]: INDIRECT from v_motor, weight 1.9 (5.58 dB), damping 0.8, BANDPASS CRIT_DAMPING order 1 at \
             11 Hz, edges 8.588..14.09 Hz -> NOT_ACTIVE"],
    );
    assert_eq!(
        said(&list(&[("stage[1].mode              INDIRECT", "stage[1].mode              NOT_ACTIVE")]), &list(&[])),
        ["axis X: stage[1]: NOT_ACTIVE -> INDIRECT from v_motor, weight 1.9 (5.58 dB), damping 0.8, BANDPASS \
             CRIT_DAMPING order 1 at 11 Hz, edges 8.588..14.09 Hz"]
    );
}

#[test]
fn an_all_pass_more() {
    let base = "lr_param.improved_position_control.stage[0].";
    let more =
        format!("q_factor   10\n{base}filter[1].type ALLPASS\n{base}filter[1].fg_f0 51\n{base}filter[1].q_factor 10\n");
    assert_changed(
        &[("q_factor   10", &more)],
        &[
            "stage[0]: filter[1]: NO_FILTER -> ALLPASS with -180 deg at 51 Hz, -90 at 48.51 and -270 at 53.61 Hz; \
             at 53 Hz: 9.54 dB, 180 -> 284.8 deg; slowest decay to 1/e 0.06005 -> 0.0624 s",
            "stage[0]: largest weight: calm (Ms <= 2) 7 -> 0.52, stable 7 -> 1.1, with a drive that only delays 1.5 cycles",
            "stage[1]: largest weight: calm (Ms <= 2) 3.2 -> 0, stable 7 -> 0, with a drive that only delays 1.5 cycles",
        ],
    );
}

#[test]
fn limit_and_start() {
    assert_changed(
        &[
            ("v_add_max_fact             1000", "v_add_max_fact 500"),
            ("enable                     TRUE", "enable DRYRUN"),
        ],
        &["limit 530000 -> 265000 (100 -> 50 % of v_max)", "starts ON -> DRYRUN"],
    );
    assert_changed(&[("530000", "400000")], &["v_max 530000 -> 400000", "limit 530000 -> 400000 (100 % of v_max)"]);
}

#[test]
fn cycle_time_real_type_and_fade() {
    let set = |cycle: &str, keys: &str| {
        let stage = "mode = \"DIRECT\", filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }]";
        toml(&format!(
            "cycle_time = \"{cycle}\"\n[axis.X]\n{keys}lr_param.improved_position_control.stage = [{{ {stage} }}]\n"
        ))
    };
    let old = set("1ms", "");
    assert_eq!(
        said(&old, &set("2ms", "")),
        [
            "axis X: cycle time 1000 -> 2000 us",
            "axis X: stage[0]: edges 50.414..55.714 -> 50.406..55.706 Hz; slowest decay to 1/e 0.06005 -> 0.06001 s",
            "axis X: stage[0]: largest weight: calm (Ms <= 2) 7 -> 3.6, stable 7, with a drive that only delays 1.5 cycles"
        ]
    );
    assert_eq!(said(&old, &set("1ms", "real = \"f32\"\n")), ["axis X: real type f64 -> f32"]);
    assert_eq!(said(&old, &set("1ms", "fade = \"200ms\"\n")), ["axis X: fade 0.1 -> 0.2 s"]);
    // Both are raised to one period of 53 Hz.
    assert_eq!(said(&set("1ms", "fade = \"1ms\"\n"), &set("1ms", "fade = \"2ms\"\n")), NONE);
}

#[test]
fn axes_that_came_and_went() {
    let axis = |name: &str, f0: &str| {
        format!(
            "[axis.{name}]\nlr_param.improved_position_control.stage = [{{ mode = \"DIRECT\", filter = [{{ order = \
             1, fg_f0 = {f0}, q_factor = 10.0 }}] }}]\n"
        )
    };
    let set = |axes: &[String]| toml(&format!("cycle_time = \"1ms\"\n{}", axes.concat()));
    let old = set(&[axis("A", "53.0"), axis("B", "11.0")]);
    let new = set(&[axis("C", "20.0"), axis("B", "11.0")]);
    assert_eq!(
        said(&old, &new),
        [
            "axis A: removed",
            "axis B: the same",
            "axis C: added: f64, cycle time 1000 us, blocks ipc",
            "axis C: added: limit 0 (0 % of v_max), starts OFF, fade 0.1 s",
            "axis C: added: stage[0]: DIRECT from v_motor, weight 1 (0 dB), BANDPASS CRIT_DAMPING order 1 at 20 Hz, \
             edges 19.02..21.02 Hz"
        ]
    );
    let other_order = set(&[axis("B", "11.0"), axis("A", "53.0")]);
    assert_eq!(said(&old, &other_order), NONE);
}

#[test]
fn a_change_of_a_last_digit_is_still_one() {
    assert_changed(
        &[("fg_f0      53", "fg_f0      53.00000000000001")],
        &["the coefficients differ by no more than their rounding"],
    );
}

/// No coefficient shows the unit of the signals, nor whose v_add a gantry slave gets.
#[test]
fn another_axis_type_and_another_master() {
    let axis =
        "\ngetriebe = [{ kv = 2000, multi_gain_z = 1, dynamik.vb_max = 500000 }]\nlr_param.improved_position_control.";
    let [own, none] = [
        "stage = [{ mode = \"DIRECT\", filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }] }]",
        "enable = \"OFF\"",
    ];
    let axes = |kind: &str, master: &str| {
        let keys = [("A", "", own), ("B", "", own), ("S", master, none), ("T", kind, own)];
        let numbered = keys.iter().zip(1..);
        let axes =
            numbered.map(|((name, key, ipc), n)| format!("[axis.{name}]\nkopf.achs_nr = {n}\n{key}{axis}{ipc}\n"));
        toml(&format!("cycle_time = \"1ms\"\n{}", axes.collect::<String>()))
    };
    let old = axes("kenngr.achs_typ = \"ACHSTYP_TRANSLATOR\"", "kenngr.gantry_ax_nr = 1");
    let lines = said(&old, &axes("kenngr.achs_typ = \"ACHSTYP_ROTATOR\"", "kenngr.gantry_ax_nr = 2"));
    assert_eq!(lines[..2], ["axis A: gantry slaves S -> none", "axis B: gantry slaves none -> S"]);
    assert_eq!(lines[2], "axis S: gantry master axis 1 -> axis 2");
    assert_eq!(lines[3..], ["axis T: axis type ACHSTYP_TRANSLATOR -> ACHSTYP_ROTATOR"]);
}
