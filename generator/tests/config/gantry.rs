//! Gantries: what a slave and its master say about each other, to the letter.

use super::{assert_said, assert_transcript, said, said_of_set};

/// What is said about a set whose axes are given.
fn said_of_axes(given: &str) -> String {
    said_of_set(&format!("cycle_time = \"1ms\"\n{given}"))
}

#[test]
fn a_gantry_slave_that_cannot_follow() {
    assert_transcript(
        said_of_axes,
        r#"
> [axis.A]
> kopf.achs_nr = 1
> kenngr = { gantry_ax_nr = 2, antr_typ = 2 }
> [axis.B]
> kopf.achs_nr = 2
> getriebe = [{ kv = 2000 }]
> lr_param.improved_position_control = { v_add_max_fact = 1000, stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }] }
set.toml:4:27: warning[AX427]: A and its master B scale their velocities differently: no additive velocity, and multi_gain 2000/1
    write instead: equal scalings, unless the drives are different
set.toml:4:27: error[AX310]: A follows B, which has improved position control, and its own process data have no additive velocity
    allowed: an additive velocity command in the process data of the slave too
    write instead: process_data.additive_velocity = "INT32" for this axis, if the drive has it
"#,
    );
}

#[test]
fn gantries() {
    assert_transcript(
        said_of_axes,
        r#"
> [axis.A]
> kopf.achs_nr = 1
> kenngr.gantry_ax_nr = 2
> vorsteuer.vorsteuerung = 'ADD_VEL'
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000 }]
> [axis.B]
> kopf.achs_nr = 2
> getriebe = [{ kv = 2000 }]

> [axis.A]
> kopf.achs_nr = 1
> kenngr = { gantry_ax_nr = 2, achs_typ = 'ACHSTYP_ROTATOR' }
> getriebe = [{ kv = 2000 }]
> [axis.B]
> kopf.achs_nr = 2
> getriebe = [{ kv = 2000 }]
set.toml:4:27: warning[AX427]: A has velocities in 0.001 deg/s, and its master B in um/s (P-AXIS-00018): the additive velocity of the one is none of the other
    write instead: equal axis types, kenngr.achs_typ (P-AXIS-00018)

> [axis.A]
> kopf.achs_nr = 1
> kenngr.gantry_ax_nr = 9
> getriebe = [{ kv = 2000 }]
> [axis.B]
> kopf.achs_nr = 2
> getriebe = [{ kv = 2000 }]
set.toml:4:23: error[AX315]: A follows the axis 9, and no axis of the set has this number
    write instead: one of 2 of B (P-AXIS-00016), or the master's list in the set

> [axis.A]
> kopf.achs_nr = 1
> kenngr.gantry_ax_nr = 2
> getriebe = [{ kv = 2000 }]
> [axis.B]
> kopf.achs_nr = 2
> kenngr.gantry_ax_nr = 3
> getriebe = [{ kv = 2000 }]
> [axis.C]
> kopf.achs_nr = 3
> kenngr.gantry_ax_nr = 1
> getriebe = [{ kv = 2000 }]
set.toml:4:23: error[AX315]: A follows B, which follows A in the end
    write instead: the number of an axis that follows no other
set.toml:8:23: error[AX315]: B follows C, which follows B in the end
    write instead: the number of an axis that follows no other
set.toml:12:23: error[AX315]: C follows A, which follows C in the end
    write instead: the number of an axis that follows no other

> [axis.A]
> kopf.achs_nr = 1
> kenngr.gantry_ax_nr = 2
> getriebe = [{ kv = 2000 }]
> [axis.B]
> kopf.achs_nr = 2
> kenngr.gantry_ax_nr = 3
> getriebe = [{ kv = 2000 }]
> [axis.C]
> kopf.achs_nr = 3
> getriebe = [{ kv = 2000 }]
set.toml:4:23: error[AX315]: A follows B, which is a slave itself
    write instead: the number of an axis that follows no other

> [axis.A]
> kopf.achs_nr = 1
> kenngr.gantry_ax_nr = 2
> getriebe = [{ kv = 2000 }]
> [axis.B]
> kopf.achs_nr = 2
> getriebe = [{ kv = 2000 }]
> [axis.C]
> kopf.achs_nr = 2
> getriebe = [{ kv = 2000 }]
set.toml:10:16: error[AX318]: C has the logical axis number 2 (P-AXIS-00016), which B has already
    write instead: [axis.C] kopf.achs_nr = with a number that no other axis has

> [axis.A]
> getriebe = [{ kv = 2000 }]
> kopf.achs_nr = 0
> [axis.B]
> getriebe = [{ kv = 2000 }]
> kopf.achs_nr = 0

> [axis.A]
> kopf.achs_nr = 1
> kenngr.gantry_ax_nr = 2
> getriebe = [{ kv = 2000, multi_gain_z = 1000 }]
> [axis.B]
> kopf.achs_nr = 2
> getriebe = [{ kv = 2000 }]
set.toml:4:23: warning[AX427]: A and its master B scale their velocities differently: multi_gain 1000/1, and multi_gain 2000/1
    write instead: equal scalings, unless the drives are different

> [axis.A]
> kopf.achs_nr = 1
> kenngr = { gantry_ax_nr = 2, antr_typ = 2 }
> process_data.additive_velocity = 'INT32'
> antr.v_reso_num = 7
> [axis.B]
> kopf.achs_nr = 2
> kenngr.antr_typ = 2
> process_data.additive_velocity = 'INT32'
> lr_param.improved_position_control = { v_add_max_fact = 1000, stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }] }
set.toml:4:27: warning[AX427]: A and its master B scale their velocities differently: v_reso 7/36, v_time_base 0, INT32, and v_reso 1/36, v_time_base 0, INT32
    write instead: equal scalings, unless the drives are different
"#,
    );
}

#[test]
fn a_slave_whose_list_stands_alone() {
    assert_said(
        &said("kopf.achs_nr 2\nkenngr.gantry_ax_nr 1\ngetriebe[0].kv 2000"),
        &[
            "x.lis:2:21: warning[AX428]: the master of the gantry, axis 1 (P-AXIS-00070), is not there: its additive velocity is \
             left out",
            "    write instead: a set with both axes, whose lists they name",
        ],
    );
}
