//! Numbers that were mostly written in another unit, or in the wrong place: warnings, to the letter.

use super::{assert_transcript, direct, in_cnc, read, said, said_of_axis, said_of_set, short};
use generator::config::ListOptions;

#[test]
fn velocities_and_decelerations_of_spindles_in_rpm() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r#"
> antr.sai_op_mode_change.v_velocity_control_on = 200
> antr.sai_op_mode_change.v_position_control_on = 50
> spindle = { deceleration = 5000, window = 10, takeover_window = 1 }
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
set.toml:3:49: warning[AX462]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 200, which is only 0.0333333 rpm
    write instead: 1200000, if 200 rpm is meant, or 200000, if 200 deg/s is meant: the unit is 0.001 deg/s
set.toml:4:49: warning[AX462]: `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) is 50, which is only 0.00833333 rpm
    write instead: 300000, if 50 rpm is meant, or 50000, if 50 deg/s is meant: the unit is 0.001 deg/s
set.toml:5:28: warning[AX462]: `spindle.deceleration` is 5000, which is only 0.833333 rpm/s: braking from vb_max takes 3599.99 s
    write instead: 30000000, if 5000 rpm/s is meant, or 5000000, if 5000 deg/s^2 is meant: the unit is 0.001 deg/s^2
set.toml:5:43: warning[AX462]: `spindle.window` is 10, which is only 0.00166667 rpm
    write instead: 60000, if 10 rpm is meant, or 10000, if 10 deg/s is meant: the unit is 0.001 deg/s
set.toml:5:65: warning[AX462]: `spindle.takeover_window` is 1, which is only 0.001 deg
    write instead: 1000, if 1 deg is meant: the unit is 0.001 deg

> antr.sai_op_mode_change.v_velocity_control_on = 20000
> antr.sai_op_mode_change.v_position_control_on = 6000
> getriebe = [{ kv = 2000, dynamik.vb_max = 144000000 }]
set.toml:3:49: warning[AX462]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 20000, which is only 3.33333 rpm
    write instead: 120000000, if 20000 rpm is meant, or 20000000, if 20000 deg/s is meant: the unit is 0.001 deg/s
set.toml:4:49: warning[AX462]: `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) is 6000, which is only 1 rpm
    write instead: 36000000, if 6000 rpm is meant, or 6000000, if 6000 deg/s is meant: the unit is 0.001 deg/s

> antr.sai_op_mode_change.v_velocity_control_on = 1200000
> antr.sai_op_mode_change.v_position_control_on = 6000
> spindle = { deceleration = 179941, window = 600, takeover_window = 10 }
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
"#,
    );
}

#[test]
fn the_largest_velocity_of_a_spindle_in_rpm() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r#"
> antr.sai_op_mode_change.v_velocity_control_on = 6000
> antr.sai_op_mode_change.v_position_control_on = 6000
> getriebe = [{ kv = 2000, dynamik.vb_max = 12000 }]
set.toml:5:43: warning[AX438]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 12000, which is only 12 deg/s
    write instead: 12000000, if 12000 deg/s is meant, or 72000000, if 12000 revolutions/min is meant: the unit is 0.001 deg/s
"#,
    );
}

#[test]
fn a_gain_of_the_position_controller_in_1_per_second() {
    assert_transcript(
        said_of_axis,
        r#"
> kenngr.achs_typ = 'ACHSTYP_ROTATOR'
> getriebe = [{ kv = 20, multi_gain_z = 2000, multi_gain_n = 1, dynamik.vb_max = 600000 }]
set.toml:4:20: warning[AX463]: `getriebe[0].kv` (P-AXIS-00099) is 20, which is only 0.2/s: at vb_max 600000 the axis lags by 3000 deg
    write instead: 2000, if 20/s is meant: the unit is 0.01/s

> getriebe = [{ kv = 100, multi_gain_z = 2000, multi_gain_n = 1, dynamik.vb_max = 600000 }]
"#,
    );
}

#[test]
fn unequal_gains_in_a_gantry() {
    assert_transcript(
        |given| said_of_set(&format!("cycle_time = \"1ms\"\n{given}")),
        r#"
> [axis.A]
> kopf.achs_nr = 1
> kenngr.gantry_ax_nr = 2
> getriebe = [{ kv = 2000, dynamik.vb_max = 500000 }]
> [axis.B]
> kopf.achs_nr = 2
> getriebe = [{ kv = 4000, dynamik.vb_max = 600000 }]
set.toml:4:23: warning[AX464]: A has Kv 20/s, and its master B 40/s (P-AXIS-00099): without feedforward the gantry is askew by 12.5 mm at 500000 um/s
    write instead: kv = 4000 of A, or equal values in both, and in their drives
"#,
    );
}

#[test]
fn a_weight_without_its_denominator() {
    assert_transcript(
        |given| said(&direct(given)),
        r#"
> ipc.stage[0].weight_fact_num 5
x.lis:1:61: warning[AX465]: `ipc.stage[0].weight_fact_num` (P-AXIS-00754) is 5, and without weight_fact_denom the weight is 5: 500 %
    write instead: ipc.stage[0].weight_fact_denom (P-AXIS-00755) with 100, if 5 % is meant, or with 1

> ipc.stage[0].weight_fact_num 1

> ipc.stage[0].weight_fact_num 5
> ipc.stage[0].weight_fact_denom 1
"#,
    );
}

#[test]
fn command_filters_beside_stages() {
    assert_transcript(
        |given| said(&direct(given)),
        r#"
> filter[0].enable 1
> filter[0].order 2
> filter[1].enable TRUE
> filter[1].order 0
> filter[2].enable 0
> filter[2].order 2
x.lis:1:18: warning[AX467]: the command filter filter[0] is on (P-AXIS-00319, 00140): it delays the command, and turns its phase
    write instead: the filter off while the stages are tuned; or tune with it, and again when it changes

> filter[0].type 8
> filter[0].order 20
x.lis:2:17: warning[AX467]: filter[0] is an HSC filter, which the NC program switches on: it delays the command, and turns its phase
    write instead: the filter off while the stages are tuned; or tune with it, and again when it changes

> filter[0].prototype 5
> filter[0].time_constant 10000
x.lis:2:25: warning[AX467]: filter[0] is an HSC filter, which the NC program switches on: it delays the command, and turns its phase
    write instead: the filter off while the stages are tuned; or tune with it, and again when it changes

> filter_fir.enable 1
> filter_fir.type 2
x.lis:1:19: warning[AX467]: the command filter filter_fir is on (P-AXIS-00573, 00586): it delays the command, and turns its phase
    write instead: the filter off while the stages are tuned; or tune with it, and again when it changes

> filter_fir.enable 1
> filter_fir.type 0
"#,
    );
}

#[test]
fn a_watch_that_sees_nothing_in_time() {
    assert_transcript(
        said_of_axis,
        r#"
> watch = true
> ipc.v_add_max_fact = 2000
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:3:9: warning[AX468]: the watch over the loop sees nothing: it waits for 400000 um/s, 200 % of vb_max (P-AXIS-00757), which the axis hardly reaches
    write instead: a v_add_max_fact that is a little more than what the vibration needs

> watch = true
> getriebe = [{ kv = 2000 }]
set.toml:3:9: warning[AX468]: the watch over the loop sees nothing: no stage is active
    write instead: an active stage, or no `watch`

> watch = true
> ipc.v_add_max_fact = 999
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
"#,
    );
}

#[test]
fn tuning_that_starts_at_0() {
    assert_transcript(
        said_of_axis,
        r#"
> tunable = 'weights'
> tuning_limit = 0
> ipc.v_add_max_fact = 100
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:4:16: warning[AX469]: `tuning_limit` is 0: the block adds nothing until its input tuning_limit is written
    write instead: a part from 0 to 1, or a caller that writes tuning_limit

> tunable = 'weights'
> ipc.v_add_max_fact = 100
> ipc.stage = [{ mode = 'DIRECT', tuning_weight = 0, filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:5:80: warning[AX469]: `ipc.stage[0].tuning_weight` is 0: the block adds nothing until its input tuning_weight is written
    write instead: a part from 0 to 1, or a caller that writes tuning_weight
"#,
    );
}

#[test]
fn an_empty_array() {
    assert_transcript(
        said_of_axis,
        r#"
> ipc.stage = []
set.toml:3:36: error[AX204]: `ipc.stage` is an empty array: it gives nothing, and what a list has there stays
    allowed: an array with an element at the least
    write instead: stage = [{ mode = "NOT_ACTIVE" }, ...] for each stage of the list that is to go, or no line

> ipc.stage = [{ filter = [] }]
set.toml:3:47: error[AX204]: `ipc.stage[0].filter` is an empty array: it gives nothing, and what a list has there stays
    allowed: an array with an element at the least
    write instead: no line, or an element with its parameters
"#,
    );
}

/// What is said of an axis `name` whose list has another name.
fn said_of_list(name: &str, in_list: &str) -> String {
    let set = format!("cycle_time = \"1ms\"\n[axis.{name}]\nlist = \"x.lis\"\n");
    let list = direct("").replace("ipc.", super::IPC) + "\nkopf.log_achs_name " + in_list + "\n";
    let files = [("set.toml", set.as_bytes()), ("x.lis", list.as_bytes())];
    short(&read("set.toml", &files, &ListOptions::default()).1)
}

#[test]
fn a_list_of_another_axis() {
    let expected = "x.lis:7:20: warning[AX466]: the list of the axis X has the name of another axis: `Y`\n    \
                    write instead: in [axis.X] the list of this axis, or the axis with the name in the list";
    assert_eq!(said_of_list("X", "Y"), expected);
    for (name, in_list) in [("X", "X"), ("X", "\"x\""), ("Achse_1", "ACHSE1")] {
        assert_eq!(said_of_list(name, in_list), "", "{name} {in_list}");
    }
}
