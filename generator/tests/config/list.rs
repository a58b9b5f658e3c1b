//! Reading axis lists.

use super::{assert_said, assert_transcript, direct, indirect, read_list, said};

#[test]
fn a_valid_stage_says_nothing() {
    assert_said(&said(&direct("")), &[]);
}

#[test]
fn nothing_at_all() {
    assert_said(
        &said(""),
        &[
            "x.lis: error[AX110]: no parameter of an axis is in the file: it is empty, or has nothing but comments",
            "    allowed: an axis list",
            "    write instead: the name of an axis list",
        ],
    );
}

#[test]
fn comments_crlf_tabs_and_blanks() {
    assert_said(
        &said(&direct(
            "# c\r\n(c\r\n  ( c\r\n\r\nkenngr.swe_pos\t1 # \u{e4} \u{20ac}\r\nkopf.achs_nr\t 3\t( P-AXIS-00016\r\n",
        )),
        &[],
    );
}

#[test]
fn words_in_any_case_and_numbers() {
    assert_said(
        &said(
            "ipc.v_add_max_fact 0x3E8\n\
             ipc.enable dryrun\n\
             ipc.stage[].mode 1\n\
             ipc.stage[].filter.order 0x2\n\
             ipc.stage[].filter.fg_f0 5.3e1\n\
             ipc.stage[].filter.q_factor 0xA\n\
             ipc.stage[].filter.type bandpass\n\
             getriebe[].dynamik.vb_max 0x30D40",
        ),
        &[],
    );
}

#[test]
fn byte_order_mark() {
    assert_said(&said(&direct("\u{feff}kopf.achs_nr 1")), &[]);
}

#[test]
fn byte_outside_of_a_comment() {
    assert_said(
        &said(&direct("kopf.log_achs_name \u{e4}\nkopf.achs_nr \u{e4}")),
        &[
            "x.lis:2:14: error[AX102]: the character U+00E4 outside of a comment",
            "    allowed: printable ASCII and tabs; any byte in a comment",
            "    write instead: the line without it, or a `#` before the comment",
        ],
    );
}

#[test]
fn control_character() {
    assert_said(
        &said(&direct("kopf.achs_nr\u{b}1")),
        &[
            "x.lis:1:13: error[AX102]: byte 0x0B outside of a comment",
            "    allowed: printable ASCII and tabs; any byte in a comment",
            "    write instead: the line without it, or a `#` before the comment",
        ],
    );
}

#[test]
fn no_path() {
    assert_said(
        &said(&direct(
            "kopf.achs_nr=1\n\
             ?\n\
             kenngr..x 1\n\
             a[x] 1\n\
             5 1",
        )),
        &[
            "x.lis:1:1: error[AX101]: `kopf.achs_nr=1` is no path",
            "    allowed: path value # comment",
            "    write instead: kopf.achs_nr 1",
            "x.lis:2:1: error[AX101]: `?` is no path",
            "    allowed: path value # comment",
            "x.lis:3:1: error[AX101]: `kenngr..x` is no path",
            "    allowed: path value # comment",
            "x.lis:4:1: error[AX101]: `a[x]` is no path",
            "    allowed: path value # comment",
            "x.lis:5:1: error[AX101]: `5` is no path",
            "    allowed: path value # comment",
        ],
    );
}

#[test]
fn equals_sign_behind_the_path() {
    assert_said(
        &said(&direct("kopf.achs_nr = 1")),
        &[
            "x.lis:1:14: error[AX101]: `kopf.achs_nr` (P-AXIS-00016) is `= 1`: a list has no `=`",
            "    allowed: 0 <= achs_nr <= 65535",
            "    write instead: kopf.achs_nr 1",
        ],
    );
}

#[test]
fn two_values() {
    assert_said(
        &said(&direct("kopf.achs_nr 1 2")),
        &[
            "x.lis:1:14: error[AX101]: `kopf.achs_nr` (P-AXIS-00016) is `1 2`: more than one value",
            "    allowed: 0 <= achs_nr <= 65535",
        ],
    );
}

#[test]
fn no_value() {
    assert_said(
        &said(&direct(
            "ipc.enable\n\
             kopf.achs_nr # 1\n\
             kenngr.foreign",
        )),
        &[
            "x.lis:1:42: error[AX103]: `ipc.enable` (P-AXIS-00758) has no value",
            "    allowed: OFF (FALSE, 0), ON (TRUE, 1), DRYRUN",
            "x.lis:2:13: error[AX103]: `kopf.achs_nr` (P-AXIS-00016) has no value",
            "    allowed: 0 <= achs_nr <= 65535",
        ],
    );
}

#[test]
fn unknown_but_close() {
    assert_said(
        &said(&direct(
            "ipc.enabel ON\n\
             ipc.stage[0].wieght_fact_num 3\n\
             ipc.stage[2].fg_f0 3\n\
             ipc.stage[0].filter[1].qfactor 3\n\
             LR_PARAM.IMPROVED_POSITION_CONTROL.ENABLE ON\n\
             lr_param.improved_postion_control.enable ON",
        )),
        &[
            "x.lis:1:1: error[AX104]: `ipc.enabel` is not known",
            "    write instead: ipc.enable",
            "x.lis:2:1: error[AX104]: `ipc.stage[0].wieght_fact_num` is not known",
            "    write instead: ipc.stage[0].weight_fact_num",
            "x.lis:3:1: error[AX104]: `ipc.stage[2].fg_f0` is not known",
            "    write instead: ipc.stage[2].filter[0].fg_f0",
            "x.lis:4:1: error[AX104]: `ipc.stage[0].filter[1].qfactor` is not known",
            "    write instead: ipc.stage[0].filter[1].q_factor",
            "x.lis:5:1: error[AX104]: `LR_PARAM.IMPROVED_POSITION_CONTROL.ENABLE` is not known",
            "    write instead: ipc.enable",
            "x.lis:6:1: error[AX104]: `lr_param.improved_postion_control.enable` is not known",
            "    write instead: ipc.enable",
        ],
    );
}

#[test]
fn unknown_and_not_close() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].colour 3\n\
             ipc.stage[0].x.y 3",
        )),
        &[
            "x.lis:1:1: warning[AX105]: `ipc.stage[0].colour` is not known, and passed over",
            "x.lis:2:1: warning[AX105]: `ipc.stage[0].x.y` is not known, and passed over",
        ],
    );
}

#[test]
fn index_out_of_range() {
    assert_said(
        &said(&direct(
            "ipc.stage[3].mode DIRECT\n\
             ipc.stage[0].filter[2].order 1\n\
             ipc.stage[0].filter[1].damping 1\n\
             getriebe[16].dynamik.vb_max 1\n\
             ipc.stage[4294967296].mode 0",
        )),
        &[
            "x.lis:1:1: error[AX106]: `ipc.stage[3].mode` has an index that does not exist",
            "    allowed: ipc.stage[i].mode with 0 <= i <= 2",
            "x.lis:2:1: error[AX106]: `ipc.stage[0].filter[2].order` has an index that does not exist",
            "    allowed: ipc.stage[i].filter[k].order with 0 <= i <= 2, 0 <= k <= 1",
            "x.lis:3:1: error[AX106]: `ipc.stage[0].filter[1].damping` has an index that does not exist",
            "    allowed: ipc.stage[i].filter.damping with 0 <= i <= 2",
            "x.lis:4:1: error[AX106]: `getriebe[16].dynamik.vb_max` has an index that does not exist",
            "    allowed: getriebe[i].dynamik.vb_max with 0 <= i <= 15",
            "x.lis:5:1: error[AX106]: `ipc.stage[4294967296].mode` has an index that does not exist",
            "    allowed: ipc.stage[i].mode with 0 <= i <= 2",
        ],
    );
}

#[test]
fn given_twice() {
    assert_said(
        &said(&direct(
            "ipc.enable ON\n\nipc.enable ON\nipc.stage[0].filter[0].order 1\nipc.stage[].filter.order 1\nkenngr.foreign 1\nkenngr.foreign 1",
        )),
        &[
            "x.lis:3:1: error[AX107]: `ipc.enable` is given twice, first in line 1",
            "    write instead: one of the two lines",
            "x.lis:5:1: error[AX107]: `ipc.stage[].filter.order` is given twice, first in line 4",
            "    write instead: one of the two lines",
            "x.lis:10:1: error[AX107]: `ipc.stage[0].filter.order` is given twice, first in line 4",
            "    write instead: one of the two lines",
        ],
    );
}

#[test]
fn misprint_of_the_manual() {
    assert_said(
        &said(&indirect("ipc.stage[0]osc_damping 0.5")),
        &[
            "x.lis:1:1: warning[AX108]: `ipc.stage[0]osc_damping` is a misprint of the manual",
            "    write instead: ipc.stage[0].osc_damping",
        ],
    );
}

#[test]
fn misprint_and_the_proper_path_are_one() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0]osc_damping 0.5\n\
             ipc.stage[0].osc_damping 0.5",
        )),
        &[
            "x.lis:1:1: warning[AX108]: `ipc.stage[0]osc_damping` is a misprint of the manual",
            "    write instead: ipc.stage[0].osc_damping",
            "x.lis:2:1: error[AX107]: `ipc.stage[0].osc_damping` is given twice, first in line 1",
            "    write instead: one of the two lines",
        ],
    );
}

#[test]
fn keys_of_a_set() {
    assert_said(
        &said(&direct(
            "real f32\n\
             cycle_time 1ms\n\
             ipc.stage[0].direct_source v_direct",
        )),
        &[
            "x.lis:1:1: error[AX109]: `real` is a key of an axis set; no axis list has it",
            "    write instead: `real` in a TOML set whose axis names this list",
            "x.lis:2:1: error[AX109]: `cycle_time` is a key of an axis set; no axis list has it",
            "    write instead: the option --cycle-time",
            "x.lis:3:1: error[AX109]: `ipc.stage[0].direct_source` is a key of an axis set; no axis list has it",
            "    write instead: `ipc.stage[0].direct_source` in a TOML set whose axis names this list",
        ],
    );
}

#[test]
fn gear_steps() {
    assert_said(
        &said(&direct(
            "getriebe[0].dynamik.vb_max 5000\n\
             getriebe[2].dynamik.vb_max 2000",
        )),
        &[
            "x.lis:2:28: warning[AX403]: the gear steps 0, 2 are given; step 0 is used",
            "    write instead: the key `gear` in a set, to choose one",
        ],
    );
}

#[test]
fn another_gear_step_than_the_one_that_is_used() {
    assert_said(
        &said(&direct("getriebe[1].dynamik.vb_max 1000")),
        &[
            "x.lis:1:28: warning[AX403]: gear step 0 is used, and lacks what other steps have: dynamik.vb_max (P-AXIS-00212), whose default 200000 holds",
            "    write instead: the parameters getriebe[0], or the key `gear` of another step",
        ],
    );
}

#[test]
fn many_lines_that_cannot_be_read() {
    let said = said(&direct(&"\u{1}\u{2}\n".repeat(1000)));
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines.len(), 20 * 3 + 2);
    assert_eq!(lines[59], "    write instead: the line without it, or a `#` before the comment");
    assert_said(
        &lines[60..].join("\n"),
        &[
            "x.lis: error[AX110]: 20 lines that no axis list has; the rest is not read",
            "    write instead: the name of an axis list",
        ],
    );
}

#[test]
fn foreign_parameters_are_passed_over_and_counted() {
    let foreign =
        "kenngr.swe_pos 15000000 ( P-AXIS-00178\nantr.x[1][2] MVS_SVS M 3\nlr_param.other 1\nlist_without_value\n";
    let (set, report) = read_list(foreign.to_owned() + &direct("").replace("ipc.", super::IPC));
    assert_eq!((set.unwrap().foreign, report.to_string().as_str()), (4, ""));
}

/// A path that is known but for its indices or its capitals must not be taken for another function's.
#[test]
fn other_indices_than_the_parameter_has() {
    assert_transcript(
        said,
        r"
> vorsteuer[0].vorsteuerung VEL
> getriebe.kv 1000
> Getriebe[2].dynamik[1].VB_MAX 1000
> kopf[].achs_nr 1
> ipc.enable[0] ON
> ipc.stage.mode DIRECT
> lr_param[0].improved_position_control.stage[2].filter.order 1
x.lis:1:1: error[AX104]: `vorsteuer[0].vorsteuerung` is not known
    write instead: vorsteuer.vorsteuerung
x.lis:2:1: error[AX104]: `getriebe.kv` is not known
    write instead: getriebe[0].kv
x.lis:3:1: error[AX104]: `Getriebe[2].dynamik[1].VB_MAX` is not known
    write instead: getriebe[2].dynamik.vb_max
x.lis:4:1: error[AX104]: `kopf[].achs_nr` is not known
    write instead: kopf.achs_nr
x.lis:5:1: error[AX104]: `ipc.enable[0]` is not known
    write instead: ipc.enable
x.lis:6:1: error[AX104]: `ipc.stage.mode` is not known
    write instead: ipc.stage[0].mode
x.lis:7:1: error[AX104]: `lr_param[0].improved_position_control.stage[2].filter.order` is not known
    write instead: ipc.stage[2].filter[0].order
",
    );
}

/// Nothing uses it: a real machine's list may have it for another function, or it is a slip.
#[test]
fn a_value_that_nobody_can_read_and_nothing_uses() {
    assert_transcript(
        |given| said(&direct(given)),
        r"
> vorsteuer.velocity_delay_time abc
> antr.v_reso_num xyz
> antr.v_reso_denom -5
x.lis:2:17: warning[AX201]: `antr.v_reso_num` (P-AXIS-00206) is `xyz`, no whole number
    allowed: a whole number, 0 <= v_reso_num <= 4294967295 [increments]
x.lis:1:31: warning[AX201]: `vorsteuer.velocity_delay_time` (P-AXIS-00389) is `abc`, no whole number
    allowed: a whole number, 0 <= velocity_delay_time <= 65535 [us]

> antr.v_reso_num = 7
x.lis:1:17: error[AX101]: `antr.v_reso_num` (P-AXIS-00206) is `= 7`: a list has no `=`
    allowed: 0 <= v_reso_num <= 4294967295 [increments]
    write instead: antr.v_reso_num 7

> getriebe[0].load
x.lis:1:17: warning[AX103]: `getriebe[0].load` (P-AXIS-00391) has no value
    allowed: 0 <= load <= 1.7976931348623157e308 [kg m^2, linear motor: kg]

> kenngr.antr_typ
x.lis:1:16: error[AX103]: `kenngr.antr_typ` (P-AXIS-00020) has no value
    allowed: CONVENTIONAL (ANTR_TYP_KONV, 1), SERCOS (ANTR_TYP_SERCOS, 2), PROFIDRIVE (ANTR_TYP_PROFIDRIVE, 3), SIMULATION (ANTR_TYP_SIMU, 4), LIGHTBUS (ANTR_TYP_LIGHTBUS, 5), TERMINAL (ANTR_TYP_TERM, 6), RT_ETHERNET (ANTR_TYP_ETHERNET, 7), CANOPEN (ANTR_TYP_CANOPEN, 8), VIRTUAL (ANTR_TYP_VIRTUELL, 16), CAN_BUS (ANTR_TYP_CAN, 32)
",
    );
}

/// Lines that would be another function's, and were meant to be ours.
#[test]
fn lines_that_are_nearly_ours() {
    assert_transcript(
        said,
        r"
> ipc.stage[0].weight fact denom 200
> lr_param.improved position_control.enable ON
> getriebe[0].dynamik.vb max 500000 # um/s
> getriebe[1].multi gain_z
> antr.v_reso denom 36
> getriebe[1].muIti_gain_n 1
> vorsteuer.veIocity_deIay_time 100
> antr.v_time_bae 1
> getriebe[2].mulit_gain_n 1
> vorsteuer.feedforward VEL
x.lis:1:1: error[AX104]: `ipc.stage[0].weight` is not known: its name has `_` where the line has blanks
    write instead: ipc.stage[0].weight_fact_denom 200
x.lis:2:1: error[AX104]: `lr_param.improved` is not known: its name has `_` where the line has blanks
    write instead: ipc.enable ON
x.lis:3:1: error[AX104]: `getriebe[0].dynamik.vb` is not known: its name has `_` where the line has blanks
    write instead: getriebe[0].dynamik.vb_max 500000
x.lis:4:1: error[AX104]: `getriebe[1].multi` is not known: its name has `_` where the line has blanks
    write instead: getriebe[1].multi_gain_z
x.lis:5:1: error[AX104]: `antr.v_reso` is not known: its name has `_` where the line has blanks
    write instead: antr.v_reso_denom 36
x.lis:6:1: error[AX104]: `getriebe[1].muIti_gain_n` is not known
    write instead: getriebe[1].multi_gain_n
x.lis:7:1: error[AX104]: `vorsteuer.veIocity_deIay_time` is not known
    write instead: vorsteuer.velocity_delay_time
x.lis:8:1: error[AX104]: `antr.v_time_bae` is not known
    write instead: antr.v_time_base
x.lis:9:1: error[AX104]: `getriebe[2].mulit_gain_n` is not known
    write instead: getriebe[2].multi_gain_n
x.lis:10:1: error[AX104]: `vorsteuer.feedforward` is not known
    write instead: vorsteuer.vorsteuerung

> kenngr.weight fact
> antr.v reso
x.lis: warning[AX401]: no stage is active: the block puts out 0
    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT
",
    );
}
