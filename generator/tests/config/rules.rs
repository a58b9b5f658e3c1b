//! The rules of improved position control, letter by letter as the tests name them, and the limits of the design.

use super::{assert_said, direct, indirect, said, said_of_axis, said_of_set};

#[test]
fn a_filter_without_index_is_filter_0() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter.order 1\n\
             ipc.stage[0].filter[0].order 1",
        )),
        &[
            "x.lis:2:1: error[AX107]: `ipc.stage[0].filter[0].order` is given twice, first in line 1",
            "    write instead: one of the two lines",
        ],
    );
}

#[test]
fn b_only_what_the_mode_uses_is_judged() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter.damping 1\n\
             ipc.stage[1].mode NOT_ACTIVE\n\
             ipc.stage[1].filter.order 9\n\
             ipc.stage[1].filter.fg_f0 9999\n\
             ipc.stage[1].filter.damping 1\n\
             ipc.stage[1].weight_fact_num 0\n\
             ipc.stage[0].filter[1].type NO_FILTER\n\
             ipc.stage[0].filter[1].fg_f0 -7",
        )),
        &[],
    );
}

#[test]
fn b_order_of_an_allpass_is_not_judged() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter[1].type ALLPASS\n\
             ipc.stage[0].filter[1].order 9\n\
             ipc.stage[0].filter[1].fg_f0 40\n\
             ipc.stage[0].filter[1].q_factor 2",
        )),
        &[],
    );
}

#[test]
fn c_both_dampings_and_different() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0].osc_damping 0.5\n\
             ipc.stage[0].filter.damping 0.8",
        )),
        &[
            "x.lis:1:57: error[AX303]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is 0.5, and its predecessor `ipc.stage[0].filter.damping` (P-AXIS-00756) is 0.8",
            "    allowed: one of the two, or equal values",
            "    write instead: only P-AXIS-00850",
        ],
    );
}

#[test]
fn c_both_dampings_and_equal() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0].osc_damping 0.5\n\
             ipc.stage[0].filter.damping 0.5",
        )),
        &[
            "x.lis:2:60: warning[AX404]: stage[0].filter.damping (P-AXIS-00756) stands beside `ipc.stage[0].osc_damping` of the newer parameters",
            "    write instead: ipc.stage[0].osc_damping (P-AXIS-00850) alone",
        ],
    );
}

#[test]
fn c_only_the_predecessor() {
    assert_said(&said(&indirect("ipc.stage[0].filter.damping 0.5")), &[]);
}

#[test]
fn c_only_the_predecessor_is_set() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0].filter.damping 0.5\n\
             ipc.stage[0].osc_damping -1",
        )),
        &[],
    );
}

#[test]
fn c_only_the_successor_is_set() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0].filter.damping -1\n\
             ipc.stage[0].osc_damping 0.5",
        )),
        &[],
    );
}

#[test]
fn c_the_predecessor_beside_filter_k() {
    assert_said(
        &said(&indirect(
            "ipc.stage[0].filter.damping 0.5\n\
             ipc.stage[0].filter[0].type BANDPASS",
        )),
        &[
            "x.lis:1:60: warning[AX404]: stage[0].filter.damping (P-AXIS-00756) stands beside `ipc.stage[0].filter[0].type` of the newer parameters",
            "    write instead: ipc.stage[0].osc_damping (P-AXIS-00850) alone",
        ],
    );
}

#[test]
fn d_defaults_outside_of_their_range() {
    assert_said(
        &said(
            "ipc.v_add_max_fact 1000\n\
             ipc.stage[0].mode INDIRECT\n\
             ipc.stage[2].mode DIRECT\n\
             ipc.stage[2].filter[1].type ALLPASS\n\
             ipc.stage[2].filter[1].q_factor 2",
        ),
        &[
            "x.lis:2:1: error[AX206]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is missing; its default -1 is outside of its range",
            "    allowed: 0 < osc_damping < 1",
            "    write instead: ipc.stage[0].osc_damping with a value",
            "x.lis:2:1: error[AX206]: `ipc.stage[0].filter[0].order` (P-AXIS-00750) is missing; its default 0 is outside of its range",
            "    allowed: 1 <= order <= 3",
            "    write instead: ipc.stage[0].filter[0].order with a value",
            "x.lis:2:1: error[AX206]: `ipc.stage[0].filter[0].fg_f0` (P-AXIS-00751) is missing; its default -1 is outside of its range",
            "    allowed: 0 < fg_f0 <= 500 [Hz]",
            "    write instead: ipc.stage[0].filter[0].fg_f0 with a value",
            "x.lis:2:1: error[AX206]: `ipc.stage[0].filter[0].q_factor` (P-AXIS-00752) is missing; its default -1 is outside of its range",
            "    allowed: 1 <= q_factor <= 10",
            "    write instead: ipc.stage[0].filter[0].q_factor with a value",
            "x.lis:3:1: error[AX206]: `ipc.stage[2].filter[0].order` (P-AXIS-00750) is missing; its default 0 is outside of its range",
            "    allowed: 1 <= order <= 3",
            "    write instead: ipc.stage[2].filter[0].order with a value",
            "x.lis:3:1: error[AX206]: `ipc.stage[2].filter[0].fg_f0` (P-AXIS-00751) is missing; its default -1 is outside of its range",
            "    allowed: 0 < fg_f0 <= 500 [Hz]",
            "    write instead: ipc.stage[2].filter[0].fg_f0 with a value",
            "x.lis:3:1: error[AX206]: `ipc.stage[2].filter[0].q_factor` (P-AXIS-00752) is missing; its default -1 is outside of its range",
            "    allowed: 1 <= q_factor <= 10",
            "    write instead: ipc.stage[2].filter[0].q_factor with a value",
            "x.lis:3:1: error[AX206]: `ipc.stage[2].filter[1].fg_f0` (P-AXIS-00751) is missing; its default -1 is outside of its range",
            "    allowed: 0 < fg_f0 <= 500 [Hz]",
            "    write instead: ipc.stage[2].filter[1].fg_f0 with a value",
        ],
    );
}

#[test]
fn e_no_stage_is_left_out_because_of_an_error() {
    assert_said(
        &said(&direct(
            "ipc.stage[1].mode DIRECT\n\
             ipc.stage[1].filter.order 7\n\
             ipc.stage[1].filter.fg_f0 12\n\
             ipc.stage[1].filter.q_factor 2",
        )),
        &["x.lis:2:58: error[AX203]: `ipc.stage[1].filter.order` (P-AXIS-00750) is 7", "    allowed: 1 <= order <= 3"],
    );
}

#[test]
fn g_gantry_slave_enabled() {
    assert_said(
        &said(&direct(
            "kopf.achs_nr 2\n\
             kenngr.gantry_ax_nr 1\n\
             ipc.enable ON",
        )),
        &[
            "x.lis:3:43: error[AX305]: improved position control is enabled on a gantry slave, whose master is axis 1 (P-AXIS-00070): error 70600 of the controller",
            "    write instead: ipc.enable OFF here, and the stages in the list of axis 1",
        ],
    );
}

#[test]
fn g_gantry_slave_in_dryrun() {
    assert_said(
        &said(&direct(
            "kenngr.gantry_ax_nr 1\n\
             ipc.enable DRYRUN",
        )),
        &[
            "x.lis:2:43: error[AX305]: improved position control is enabled on a gantry slave, whose master is axis 1 (P-AXIS-00070): error 70600 of the controller",
            "    write instead: ipc.enable OFF here, and the stages in the list of axis 1",
        ],
    );
}

#[test]
fn g_gantry_master() {
    assert_said(
        &said(&direct(
            "kopf.achs_nr 1\n\
             kenngr.gantry_ax_nr 1\n\
             ipc.enable ON\n\
             ipc.v_add_max_fact 100\n\
             getriebe[0].dynamik.vb_max 200000",
        )),
        &[],
    );
}

#[test]
fn g_gantry_slave_without_a_stage() {
    assert_said(
        &said(
            "kopf.achs_nr 2\n\
             kenngr.gantry_ax_nr 1",
        ),
        &[
            "x.lis:2:1: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s",
            "    write instead: the gain of the machine, in 0.01/s",
            "x.lis:2:21: warning[AX428]: the master of the gantry, axis 1 (P-AXIS-00070), is not there: its additive velocity is left out",
            "    write instead: a set with both axes, whose lists they name",
        ],
    );
}

#[test]
fn h_a_weight_above_the_cap() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].weight_fact_num 900\n\
             ipc.stage[0].weight_fact_denom 100",
        )),
        &[
            "x.lis:1:61: warning[AX437]: stage[0] asks for the weight 900/100 = 9: it is capped at 7",
            "    write instead: weight_fact_num / weight_fact_denom <= 7; without a line weight_fact_denom (P-AXIS-00755) is 1",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].weight_fact_num 700")),
        &[
            "x.lis:1:61: warning[AX437]: stage[0] asks for the weight 700/1 = 700: it is capped at 7",
            "    write instead: weight_fact_num / weight_fact_denom <= 7; without a line weight_fact_denom (P-AXIS-00755) is 1",
        ],
    );
    assert_said(&said(&direct("ipc.stage[0].weight_fact_num 7\nipc.stage[0].weight_fact_denom 1")), &[]);
}

#[test]
fn no_bandpass() {
    assert_said(
        &said(&direct("ipc.stage[0].filter.type NO_FILTER")),
        &[
            "x.lis:1:57: error[AX301]: stage[0] is DIRECT and has no band-pass",
            "    allowed: at least one BANDPASS in every active stage (P-AXIS-00849)",
            "    write instead: ipc.stage[0].filter[0].type BANDPASS",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].filter[0].type ALLPASS")),
        &[
            "x.lis:1:60: error[AX301]: stage[0] is DIRECT and has no band-pass",
            "    allowed: at least one BANDPASS in every active stage (P-AXIS-00849)",
            "    write instead: ipc.stage[0].filter[0].type BANDPASS",
        ],
    );
}

#[test]
fn prototype_of_a_second_bandpass() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter[1].type BANDPASS\n\
             ipc.stage[0].filter[1].order 1\n\
             ipc.stage[0].filter[1].fg_f0 53\n\
             ipc.stage[0].filter[1].q_factor 2",
        )),
        &[
            "x.lis:1:60: error[AX302]: `ipc.stage[0].filter[1].prototype` (P-AXIS-00848) is missing: the band-pass in filter[1] needs it in writing",
            "    allowed: CRIT_DAMPING, BUTTERWORTH, BESSEL",
            "    write instead: ipc.stage[0].filter[1].prototype CRIT_DAMPING",
        ],
    );
}

#[test]
fn a_second_bandpass_with_its_prototype() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter[1].type BANDPASS\n\
             ipc.stage[0].filter[1].prototype CRIT_DAMPING\n\
             ipc.stage[0].filter[1].order 1\n\
             ipc.stage[0].filter[1].fg_f0 53\n\
             ipc.stage[0].filter[1].q_factor 2",
        )),
        &[],
    );
}

#[test]
fn f0_above_what_the_cycle_time_allows() {
    assert_said(
        &said(&direct("ipc.stage[0].filter.fg_f0 451")),
        &[
            "x.lis:1:58: error[AX304]: `ipc.stage[0].filter.fg_f0` (P-AXIS-00751) is 451 Hz, 0.451 of the sampling frequency",
            "    allowed: fg_f0 <= 450 Hz at a cycle time of 1ms (0.45 of the sampling frequency)",
        ],
    );
    assert_said(
        &said(&direct("ipc.stage[0].filter.fg_f0 450.0000001")),
        &[
            "x.lis:1:58: error[AX304]: `ipc.stage[0].filter.fg_f0` (P-AXIS-00751) is 450.0000001 Hz, 0.45 of the sampling frequency",
            "    allowed: fg_f0 <= 450 Hz at a cycle time of 1ms (0.45 of the sampling frequency)",
        ],
    );
}

#[test]
fn f0_of_an_allpass_above_what_the_cycle_time_allows() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter[1].type ALLPASS\n\
             ipc.stage[0].filter[1].fg_f0 480\n\
             ipc.stage[0].filter[1].q_factor 2",
        )),
        &[
            "x.lis:2:61: error[AX304]: `ipc.stage[0].filter[1].fg_f0` (P-AXIS-00751) is 480 Hz, 0.48 of the sampling frequency",
            "    allowed: fg_f0 <= 450 Hz at a cycle time of 1ms (0.45 of the sampling frequency)",
        ],
    );
}

/// At 1 ms what 1 Hz is at 62.5 us.
#[test]
fn single_precision_takes_low_frequencies() {
    assert_said(
        &said_of_axis(
            "real = \"REAL\"\n\
             ipc.v_add_max_fact = 1\n\
             ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 0.0625, q_factor = 2 }] }]",
        ),
        &[],
    );
}

#[test]
fn a_frequency_whose_period_is_too_many_cycles() {
    assert_said(
        &said_of_set(
            "cycle_time = \"62.5us\"\n\
             [axis.X]\n\
             real = \"f32\"\n\
             lr_param.improved_position_control.v_add_max_fact = 1\n\
             lr_param.improved_position_control.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 0.00095, q_factor = 2 }] }]",
        ),
        &[
            "set.toml:5:95: error[AX306]: `ipc.stage[0].filter[0].fg_f0` (P-AXIS-00751) is 0.00095 Hz: the fade lasts at least one period of it",
            "    allowed: fg_f0 >= 0.000954 Hz at a cycle time of 62.5us: 16777216 cycles",
            "    write instead: a longer cycle time",
        ],
    );
}

#[test]
fn fade_of_too_many_cycles() {
    assert_said(
        &said_of_set(
            "cycle_time = \"1us\"\n\
             [axis.X]\n\
             fade = \"20s\"\n\
             lr_param.improved_position_control.v_add_max_fact = 1\n\
             lr_param.improved_position_control.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 10, q_factor = 2 }] }]",
        ),
        &[
            "set.toml:3:8: error[AX306]: `fade` is 20 s, 20000000 cycles",
            "    allowed: 16777216 cycles: 16.777216 s at a cycle time of 1us",
            "    write instead: fade = \"16.777216s\" at the most, or a longer cycle time",
        ],
    );
}

#[test]
fn a_velocity_that_single_precision_takes_for_a_bad_sample() {
    let set = |v_max: u32| {
        said_of_axis(&format!(
            "real = \"f32\"\n\
             getriebe = [{{ dynamik.vb_max = {v_max} }}]\n\
             ipc.v_add_max_fact = 1\n\
             ipc.stage = [{{ mode = 'DIRECT', filter = [{{ order = 1, fg_f0 = 50, q_factor = 2 }}] }}]"
        ))
    };
    assert_said(&set(500_000_000), &[]);
    assert_said(
        &set(500_000_001),
        &[
            "set.toml:4:32: error[AX309]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 500000001: in single precision the block takes more than 1000000000 for a bad sample",
            "    allowed: vb_max <= 500000000 in single precision",
            "    write instead: real = \"f64\" for this axis",
        ],
    );
}
