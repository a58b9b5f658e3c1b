//! Warnings about what is legal, but inert, out of date or dangerous.

use super::{assert_said, direct, said, said_of_axis, set_point};

#[test]
fn no_stage_is_active() {
    assert_said(
        &said("ipc.enable ON"),
        &[
            "x.lis:1:43: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
}

#[test]
fn limit_0_by_default() {
    assert_said(
        &said(
            "ipc.stage[0].mode DIRECT\n\
             ipc.stage[0].filter.order 1\n\
             ipc.stage[0].filter.fg_f0 53\n\
             ipc.stage[0].filter.q_factor 10",
        ),
        &[
            "x.lis: warning[AX402]: `ipc.v_add_max_fact` (P-AXIS-00757) has the default 0: the limit is 0, the block puts out 0",
            "    write instead: a limit above 0, in 0.1 % of vb_max",
        ],
    );
}

#[test]
fn limit_0() {
    assert_said(
        &said(&direct("ipc.v_add_max_fact 0")),
        &[
            "x.lis:1:51: warning[AX402]: `ipc.v_add_max_fact` (P-AXIS-00757) is 0: the limit is 0, the block puts out 0",
            "    write instead: a limit above 0, in 0.1 % of vb_max",
        ],
    );
}

#[test]
fn weight_of_set_point() {
    assert_said(
        &said(&set_point(
            "ipc.stage[0].osc_damping 0.8\n\
             ipc.stage[0].weight_fact_num 143\n\
             ipc.stage[0].weight_fact_denom 100",
        )),
        &[],
    );
    assert_said(
        &said(&set_point(
            "ipc.stage[0].osc_damping 0.8\n\
             ipc.stage[0].weight_fact_num 144\n\
             ipc.stage[0].weight_fact_denom 100",
        )),
        &[
            "x.lis:2:61: warning[AX405]: stage[0] is SET_POINT with the weight 1.44: above 1.4382 it amplifies what it is to damp",
            "    write instead: about 0.719101, the best weight at this damping",
        ],
    );
}

#[test]
fn direct_source_of_another_mode() {
    assert_said(
        &said_of_axis(
            "ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'INDIRECT', direct_source = 'v_motor', osc_damping = 0.5, filter = [{ order = 1, fg_f0 = 20, q_factor = 2 }] }, { direct_source = 'v_direct' }]",
        ),
        &[
            "set.toml:4:82: warning[AX413]: stage[0].direct_source has no effect: the stage is not DIRECT",
            "set.toml:4:184: warning[AX413]: stage[1].direct_source has no effect: the stage is not DIRECT",
        ],
    );
}

#[test]
fn near_half_the_sampling_frequency() {
    assert_said(
        &said(&set_point(
            "ipc.stage[0].osc_damping 0.8\n\
             ipc.stage[0].filter.fg_f0 351",
        )),
        &[
            "x.lis:2:58: warning[AX407]: stage[0].filter[0] lies at 0.351 of the sampling frequency: its upper skirt is squeezed against one half",
            "    write instead: a shorter cycle time, or fg_f0 below 0.35 of the sampling frequency",
        ],
    );
}

#[test]
fn stages_overlap() {
    assert_said(
        &said(&direct(
            "ipc.stage[2].mode DIRECT\n\
             ipc.stage[2].filter.order 1\n\
             ipc.stage[2].filter.fg_f0 57\n\
             ipc.stage[2].filter.q_factor 10",
        )),
        &[
            "x.lis:3:58: warning[AX409]: stage[0] (50.4137 to 55.7137 Hz) and stage[2] (54.2181 to 59.9181 Hz) overlap, and influence each other",
            "    write instead: a higher q_factor, or other frequencies",
        ],
    );
}

#[test]
fn stages_beside_each_other() {
    assert_said(
        &said(&direct(
            "ipc.stage[2].mode DIRECT\n\
             ipc.stage[2].filter.order 1\n\
             ipc.stage[2].filter.fg_f0 59\n\
             ipc.stage[2].filter.q_factor 10",
        )),
        &[],
    );
}

#[test]
fn filter_without_a_type() {
    assert_said(
        &said(&direct(
            "ipc.stage[0].filter[1].fg_f0 53\n\
             ipc.stage[0].filter[1].q_factor 2",
        )),
        &[
            "x.lis:1:61: warning[AX411]: stage[0].filter[1] has parameters and no type: it is NO_FILTER (P-AXIS-00849)",
            "    write instead: ipc.stage[0].filter[1].type BANDPASS or ALLPASS",
        ],
    );
}

#[test]
fn gantry_slave_with_stages() {
    assert_said(
        &said(&direct(
            "kopf.achs_nr 2\n\
             kenngr.gantry_ax_nr 1",
        )),
        &[
            "x.lis:2:21: warning[AX412]: the axis is a gantry slave with active stages: its input `mode` must stay OFF (error 70600)",
            "    write instead: the stages in the list of the master",
            "x.lis:2:1: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s",
            "    write instead: the gain of the machine, in 0.01/s",
            "x.lis:2:21: warning[AX428]: the master of the gantry, axis 1 (P-AXIS-00070), is not there: its additive velocity is left out",
            "    write instead: a set with both axes, whose lists they name",
        ],
    );
}

#[test]
fn a_largest_velocity_in_another_unit() {
    assert_said(
        &said(&direct("getriebe[0].dynamik.vb_max 500")),
        &[
            "x.lis:1:28: warning[AX438]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 500, which is only 0.5 mm/s",
            "    write instead: 500000, if 500 mm/s is meant, or 8333333, if 500 m/min is meant: the unit is um/s",
        ],
    );
    assert_said(
        &said(&direct("getriebe[0].dynamik.vb_max 30\nkenngr.achs_typ ACHSTYP_ROTATOR")),
        &[
            "x.lis:1:28: warning[AX438]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 30, which is only 0.03 deg/s",
            "    write instead: 30000, if 30 deg/s is meant, or 180000, if 30 revolutions/min is meant: the unit is 0.001 deg/s",
        ],
    );
    assert_said(&said(&direct("getriebe[0].dynamik.vb_max 5000")), &[]);
    assert!(said("getriebe[0].dynamik.vb_max 30\ngetriebe[0].kv 2000").starts_with("x.lis:1:28: warning[AX438]"));
}

#[test]
fn a_start_with_the_whole_velocity() {
    assert_said(
        &said(&direct("getriebe[0].dynamik.vb_max 530000\nipc.enable ON")),
        &[
            "x.lis:2:43: warning[AX439]: the block starts ON (P-AXIS-00758), and v_add may reach 530000 um/s: 100 % of vb_max (P-AXIS-00757)",
            "    write instead: ipc.enable DRYRUN for the first look, then ON with a small v_add_max_fact",
        ],
    );
    assert_said(&said(&direct("getriebe[0].dynamik.vb_max 530000\nipc.enable DRYRUN")), &[]);
    assert_said(&said(&direct("getriebe[0].dynamik.vb_max 530000\nipc.enable ON\nipc.v_add_max_fact 999")), &[]);
}
