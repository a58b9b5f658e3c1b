//! Values: numbers, words, ranges.

use super::{assert_said, direct, indirect, said};

#[test]
fn no_whole_number() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter.order 1.5\n\
             ipc.v_add_max_fact x\n\
             ipc.stage[0].weight_fact_num 1e3\n\
             ipc.stage[0].weight_fact_denom --1\n\
             kopf.achs_nr 0xG\n\
             kenngr.gantry_ax_nr 99999999999999999999",
        )),
        &[
            "x.lis:1:58: error[AX201]: `ipc.stage[0].filter.order` (P-AXIS-00750) is `1.5`, no whole number",
            "    allowed: a whole number, 1 <= order <= 3",
            "x.lis:2:51: error[AX201]: `ipc.v_add_max_fact` (P-AXIS-00757) is `x`, no whole number",
            "    allowed: a whole number, 0 <= v_add_max_fact <= 2000 [0.1 %]",
            "x.lis:3:61: error[AX201]: `ipc.stage[0].weight_fact_num` (P-AXIS-00754) is `1e3`, no whole number",
            "    allowed: a whole number, 1 <= weight_fact_num <= 4294967294",
            "x.lis:4:63: error[AX201]: `ipc.stage[0].weight_fact_denom` (P-AXIS-00755) is `--1`, no whole number",
            "    allowed: a whole number, 1 <= weight_fact_denom <= 4294967294",
            "x.lis:5:14: error[AX201]: `kopf.achs_nr` (P-AXIS-00016) is `0xG`, no whole number",
            "    allowed: a whole number, 0 <= achs_nr <= 65535",
            "x.lis:6:21: error[AX203]: `kenngr.gantry_ax_nr` (P-AXIS-00070) is `99999999999999999999`",
            "    allowed: a whole number, 0 <= gantry_ax_nr <= 65535",
        ],
    );
}

#[test]
fn no_finite_number() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0].filter.fg_f0 NaN\n\
             ipc.stage[0].filter.q_factor 1e999\n\
             ipc.stage[0].osc_damping 0,5",
        )),
        &[
            "x.lis:1:58: error[AX201]: `ipc.stage[0].filter.fg_f0` (P-AXIS-00751) is `NaN`, no finite number",
            "    allowed: a number, 0 < fg_f0 <= 500 [Hz]",
            "x.lis:2:61: error[AX201]: `ipc.stage[0].filter.q_factor` (P-AXIS-00752) is `1e999`, no finite number",
            "    allowed: a number, 1 <= q_factor <= 10",
            "x.lis:3:57: error[AX201]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is `0,5`, no finite number",
            "    allowed: a number, 0 < osc_damping < 1",
            "    write instead: 0.5",
        ],
    );
}

#[test]
fn no_finite_number_either() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0].filter.fg_f0 -inf\n\
             ipc.stage[0].filter.q_factor 1_0\n\
             ipc.stage[0].osc_damping .",
        )),
        &[
            "x.lis:1:58: error[AX201]: `ipc.stage[0].filter.fg_f0` (P-AXIS-00751) is `-inf`, no finite number",
            "    allowed: a number, 0 < fg_f0 <= 500 [Hz]",
            "x.lis:2:61: error[AX201]: `ipc.stage[0].filter.q_factor` (P-AXIS-00752) is `1_0`, no finite number",
            "    allowed: a number, 1 <= q_factor <= 10",
            "x.lis:3:57: error[AX201]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is `.`, no finite number",
            "    allowed: a number, 0 < osc_damping < 1",
        ],
    );
}

#[test]
fn words() {
    assert_said(
        &said(&direct(
            "ipc.enable 2\n\
             ipc.stage[0].mode INDIREKT\n\
             ipc.stage[1].mode 4\n\
             ipc.stage[0].filter.type LOWPASS\n\
             kenngr.achs_typ 3\n\
             ipc.stage[0].filter.prototype BUTTERWORT",
        )),
        &[
            "x.lis:1:43: error[AX202]: `ipc.enable` (P-AXIS-00758) is `2`",
            "    allowed: OFF (FALSE, 0), ON (TRUE, 1), DRYRUN",
            "x.lis:2:50: error[AX202]: `ipc.stage[0].mode` (P-AXIS-00753) is `INDIREKT`",
            "    allowed: NOT_ACTIVE (0), DIRECT (1), INDIRECT (2), SET_POINT (3)",
            "    write instead: INDIRECT",
            "x.lis:3:50: error[AX202]: `ipc.stage[1].mode` (P-AXIS-00753) is `4`",
            "    allowed: NOT_ACTIVE (0), DIRECT (1), INDIRECT (2), SET_POINT (3)",
            "x.lis:4:57: error[AX202]: `ipc.stage[0].filter.type` (P-AXIS-00849) is `LOWPASS`",
            "    allowed: NO_FILTER, BANDPASS, ALLPASS",
            "x.lis:5:17: error[AX202]: `kenngr.achs_typ` (P-AXIS-00018) is `3`",
            "    allowed: ACHSTYP_TRANSLATOR (1), ACHSTYP_ROTATOR (2), ACHSTYP_SPINDEL (4)",
            "x.lis:6:62: error[AX202]: `ipc.stage[0].filter.prototype` (P-AXIS-00848) is `BUTTERWORT`",
            "    allowed: CRIT_DAMPING, BUTTERWORTH, BESSEL",
            "    write instead: BUTTERWORTH",
        ],
    );
}

#[test]
fn long_or_strange_text_is_shortened_and_escaped() {
    assert_said(
        &said(&direct(
            "ipc.enable xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\n\
             ipc.stage[1].mode \"`'\\",
        )),
        &[
            "x.lis:1:43: error[AX202]: `ipc.enable` (P-AXIS-00758) is `xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx`",
            "    allowed: OFF (FALSE, 0), ON (TRUE, 1), DRYRUN",
            "x.lis:2:50: error[AX202]: `ipc.stage[1].mode` (P-AXIS-00753) is `\"`'\\`",
            "    allowed: NOT_ACTIVE (0), DIRECT (1), INDIRECT (2), SET_POINT (3)",
        ],
    );
}

#[test]
fn range_of_v_add_max_fact() {
    assert_said(
        &said(&direct("ipc.v_add_max_fact -1")),
        &[
            "x.lis:1:51: error[AX203]: `ipc.v_add_max_fact` (P-AXIS-00757) is -1",
            "    allowed: 0 <= v_add_max_fact <= 2000 [0.1 %]",
        ],
    );
    assert_said(
        &said(&direct("ipc.v_add_max_fact 2001")),
        &[
            "x.lis:1:51: error[AX203]: `ipc.v_add_max_fact` (P-AXIS-00757) is 2001",
            "    allowed: 0 <= v_add_max_fact <= 2000 [0.1 %]",
        ],
    );
}

#[test]
fn range_of_weight_fact_num() {
    assert_said(
        &said(&direct("ipc.stage[0].weight_fact_num 0")),
        &[
            "x.lis:1:61: error[AX203]: `ipc.stage[0].weight_fact_num` (P-AXIS-00754) is 0",
            "    allowed: 1 <= weight_fact_num <= 4294967294",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].weight_fact_num 4294967295")),
        &[
            "x.lis:1:61: error[AX203]: `ipc.stage[0].weight_fact_num` (P-AXIS-00754) is 4294967295",
            "    allowed: 1 <= weight_fact_num <= 4294967294",
        ],
    );
}

#[test]
fn range_of_weight_fact_denom() {
    assert_said(
        &said(&direct("ipc.stage[0].weight_fact_denom 0")),
        &[
            "x.lis:1:63: error[AX203]: `ipc.stage[0].weight_fact_denom` (P-AXIS-00755) is 0",
            "    allowed: 1 <= weight_fact_denom <= 4294967294",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].weight_fact_denom -5")),
        &[
            "x.lis:1:63: error[AX203]: `ipc.stage[0].weight_fact_denom` (P-AXIS-00755) is -5",
            "    allowed: 1 <= weight_fact_denom <= 4294967294",
        ],
    );
}

#[test]
fn range_of_order() {
    assert_said(
        &said(&direct("ipc.stage[0].filter.order 0")),
        &["x.lis:1:58: error[AX203]: `ipc.stage[0].filter.order` (P-AXIS-00750) is 0", "    allowed: 1 <= order <= 3"],
    );
    assert_said(
        &said(&direct("ipc.stage[0].filter.order 4")),
        &["x.lis:1:58: error[AX203]: `ipc.stage[0].filter.order` (P-AXIS-00750) is 4", "    allowed: 1 <= order <= 3"],
    );
}

#[test]
fn range_of_fg_f0() {
    assert_said(
        &said(&direct("ipc.stage[0].filter.fg_f0 0")),
        &[
            "x.lis:1:58: error[AX203]: `ipc.stage[0].filter.fg_f0` (P-AXIS-00751) is 0",
            "    allowed: 0 < fg_f0 <= 500 [Hz]",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].filter.fg_f0 500.001")),
        &[
            "x.lis:1:58: error[AX203]: `ipc.stage[0].filter.fg_f0` (P-AXIS-00751) is 500.001",
            "    allowed: 0 < fg_f0 <= 500 [Hz]",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].filter.fg_f0 -1")),
        &[
            "x.lis:1:58: error[AX203]: `ipc.stage[0].filter.fg_f0` (P-AXIS-00751) is -1",
            "    allowed: 0 < fg_f0 <= 500 [Hz]",
        ],
    );
}

#[test]
fn range_of_q_factor() {
    assert_said(
        &said(&direct("ipc.stage[0].filter.q_factor 0.999")),
        &[
            "x.lis:1:61: error[AX203]: `ipc.stage[0].filter.q_factor` (P-AXIS-00752) is 0.999",
            "    allowed: 1 <= q_factor <= 10",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].filter.q_factor 10.5")),
        &[
            "x.lis:1:61: error[AX203]: `ipc.stage[0].filter.q_factor` (P-AXIS-00752) is 10.5",
            "    allowed: 1 <= q_factor <= 10",
        ],
    );
}

#[test]
fn range_of_vb_max() {
    assert_said(
        &said(&direct("getriebe[0].dynamik.vb_max 0")),
        &[
            "x.lis:1:28: error[AX203]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 0",
            "    allowed: 1 <= vb_max <= 2000000000 [um/s or 0.001 deg/s]",
        ],
    );
    assert_said(
        &said(&direct("getriebe[0].dynamik.vb_max 2000000001")),
        &[
            "x.lis:1:28: error[AX203]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 2000000001",
            "    allowed: 1 <= vb_max <= 2000000000 [um/s or 0.001 deg/s]",
        ],
    );
}

#[test]
fn range_of_osc_damping() {
    assert_said(
        &said(&indirect("ipc.stage[0].osc_damping 0")),
        &[
            "x.lis:1:57: error[AX203]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is 0",
            "    allowed: 0 < osc_damping < 1",
        ],
    );
    assert_said(
        &said(&indirect("ipc.stage[0].osc_damping 1")),
        &[
            "x.lis:1:57: error[AX203]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is 1",
            "    allowed: 0 < osc_damping < 1",
        ],
    );
    assert_said(
        &said(&indirect("ipc.stage[0].osc_damping -1")),
        &[
            "x.lis:1:57: error[AX203]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is -1",
            "    allowed: 0 < osc_damping < 1",
        ],
    );
}

#[test]
fn range_of_filter_damping() {
    assert_said(
        &said(&indirect("ipc.stage[0].filter.damping 1")),
        &[
            "x.lis:1:60: error[AX203]: `ipc.stage[0].filter.damping` (P-AXIS-00756) is 1",
            "    allowed: 0 < damping < 1",
        ],
    );
    assert_said(
        &said(&indirect("ipc.stage[0].filter.damping 1e9")),
        &[
            "x.lis:1:60: error[AX203]: `ipc.stage[0].filter.damping` (P-AXIS-00756) is 1000000000",
            "    allowed: 0 < damping < 1",
        ],
    );
}

#[test]
fn range_of_axis_numbers() {
    assert_said(
        &said(&direct(
            "kopf.achs_nr 70000\n\
             kenngr.gantry_ax_nr -1",
        )),
        &[
            "x.lis:1:14: error[AX203]: `kopf.achs_nr` (P-AXIS-00016) is 70000",
            "    allowed: 0 <= achs_nr <= 65535",
            "x.lis:2:21: error[AX203]: `kenngr.gantry_ax_nr` (P-AXIS-00070) is -1",
            "    allowed: 0 <= gantry_ax_nr <= 65535",
        ],
    );
}

#[test]
fn ends_of_ranges_are_allowed() {
    assert_said(&said(&direct("ipc.v_add_max_fact 2000")), &[]);
    assert!(said(&direct("ipc.stage[0].weight_fact_num 4294967294")).starts_with("x.lis:1:61: warning[AX437]"));
    assert_said(&said(&direct("ipc.stage[0].weight_fact_denom 4294967294")), &[]);
    assert_said(&said(&direct("ipc.stage[0].filter.order 3")), &[]);
    assert_said(&said(&direct("ipc.stage[0].filter.q_factor 1")), &[]);
    assert_said(&said(&direct("getriebe[0].dynamik.vb_max 2000000000")), &[]);
    assert!(said(&direct("getriebe[0].dynamik.vb_max 1")).starts_with("x.lis:1:28: warning[AX438]"));
}
