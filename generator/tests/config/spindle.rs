//! Which axes have a changeover, its velocities and times, and a changeover in the CNC: what is refused and warned of, to the letter.

use super::{assert_transcript, in_cnc, said_of_axis};

#[test]
fn which_axes_have_a_changeover() {
    assert_transcript(
        said_of_axis,
        r#"
> kenngr.achs_typ = 'ACHSTYP_SPINDEL'
> getriebe = [{ kv = 2000 }]

> kenngr.achs_typ = 'ACHSTYP_ROTATOR'
> antr.sai_op_mode_change.v_velocity_control_on = 1
> antr.sai_op_mode_change.v_position_control_on = 1200000
> getriebe = [{ kv = 2000 }]
set.toml:4:49: warning[AX426]: the axis is ACHSTYP_ROTATOR (P-AXIS-00018), no spindle: P-AXIS-00767, P-AXIS-00768 without effect
    write instead: kenngr.achs_typ = "ACHSTYP_SPINDEL", if it is a spindle

> kenngr.achs_typ = 1
> antr.velocity_position_control_off = 300000
> spindle.window = 6000
> process_data.objects = ['6060h']
> getriebe = [{ kv = 2000 }]
set.toml:4:38: warning[AX426]: the axis is ACHSTYP_TRANSLATOR (P-AXIS-00018), no spindle: P-AXIS-00266 without effect
    write instead: kenngr.achs_typ = "ACHSTYP_SPINDEL", if it is a spindle
set.toml:6:24: warning[AX426]: nothing of what this axis does uses process_data.objects, spindle.window

> antr.sai_op_mode_change.v_velocity_control_on = 1200000
> antr.nbr_delay_cycles = 1
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
set.toml:3:49: warning[AX443]: `kenngr.achs_typ` (P-AXIS-00018) is not given: the axis is taken for a spindle, because of P-AXIS-00767
    write instead: kenngr.achs_typ = "ACHSTYP_SPINDEL"

> kenngr.achs_typ = 'SPINDLE'
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
> getriebe = [{ kv = 2000 }]
set.toml:3:19: error[AX202]: `kenngr.achs_typ` (P-AXIS-00018) is `SPINDLE`
    allowed: ACHSTYP_TRANSLATOR (1), ACHSTYP_ROTATOR (2), ACHSTYP_SPINDEL (4)
"#,
    );
}

/// The manual's second example of a spindle, whose values stand one line too low: all three, and the two that are left in order.
#[test]
fn changeover_velocities_the_wrong_way_round() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> antr.sai_op_mode_change.v_velocity_control_on = 1
> antr.sai_op_mode_change.v_position_control_on = 1200000
> antr.velocity_position_control_off = 300000
> getriebe = [{ kv = 6666, dynamik.vb_max = 18000000 }]
set.toml:5:38: error[AX324]: `antr.velocity_position_control_off` (P-AXIS-00266) is 300000, and its successor `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) is 1200000
    allowed: one of the two, or equal values
    write instead: only P-AXIS-00768
set.toml:3:49: error[AX320]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 1, below `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) with 1200000
    allowed: v_velocity_control_on >= v_position_control_on [0.001 deg/s]
    write instead: both velocities, each at its own name: 200 rpm are 1200000

> antr.sai_op_mode_change.v_velocity_control_on = 300000
> antr.sai_op_mode_change.v_position_control_on = 300001
set.toml:3:49: error[AX320]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 300000, below `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) with 300001
    allowed: v_velocity_control_on >= v_position_control_on [0.001 deg/s]
    write instead: both velocities, each at its own name: 200 rpm are 1200000

> antr.sai_op_mode_change.v_velocity_control_on = 300000
> antr.sai_op_mode_change.v_position_control_on = 300000

> antr.velocity_position_control_on = 200000
> antr.sai_op_mode_change.v_velocity_control_on = 200000
set.toml:3:37: warning[AX442]: `antr.velocity_position_control_on` (P-AXIS-00265) is given beside P-AXIS-00767, its successor
    write instead: only P-AXIS-00767
set.toml:4:49: error[AX320]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 200000, below `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) with 300000
    allowed: v_velocity_control_on >= v_position_control_on [0.001 deg/s]
    write instead: both velocities, each at its own name: 200 rpm are 1200000
",
    );
}

#[test]
fn predecessors() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> antr.velocity_position_control_on = 1200000
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
set.toml:3:37: warning[AX442]: `antr.velocity_position_control_on` (P-AXIS-00265) is given beside P-AXIS-00767, its successor
    write instead: only P-AXIS-00767

> antr.velocity_position_control_on = 1200001
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
set.toml:3:37: error[AX324]: `antr.velocity_position_control_on` (P-AXIS-00265) is 1200001, and its successor `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 1200000
    allowed: one of the two, or equal values
    write instead: only P-AXIS-00767

> antr.velocity_position_control_off = -1
set.toml:3:38: error[AX203]: `antr.velocity_position_control_off` (P-AXIS-00266) is -1
    allowed: 0 <= velocity_position_control_off <= 2147483647 [0.001 deg/s]

> antr.velocity_position_control_off = 2147483648
> antr.sai_op_mode_change.v_velocity_control_on = -1
set.toml:4:49: error[AX203]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is -1
    allowed: 0 <= v_velocity_control_on <= 2147483647 [0.001 deg/s]
set.toml:3:38: error[AX203]: `antr.velocity_position_control_off` (P-AXIS-00266) is 2147483648
    allowed: 0 <= velocity_position_control_off <= 2147483647 [0.001 deg/s]
",
    );
}

/// They say what their successors say.
#[test]
fn predecessors_alone() {
    assert_transcript(
        said_of_axis,
        r"
> kenngr.achs_typ = 4
> antr = { velocity_position_control_on = 1200000, velocity_position_control_off = 300000, nbr_delay_cycles = 1 }
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
set.toml:4:41: warning[AX442]: `antr.velocity_position_control_on` (P-AXIS-00265) is the predecessor of P-AXIS-00767, which takes its value
    write instead: antr.sai_op_mode_change.v_velocity_control_on = 1200000
set.toml:4:82: warning[AX442]: `antr.velocity_position_control_off` (P-AXIS-00266) is the predecessor of P-AXIS-00768, which takes its value
    write instead: antr.sai_op_mode_change.v_position_control_on = 300000

> kenngr.achs_typ = 4
> antr = { velocity_position_control_on = 299999, velocity_position_control_off = 300000, nbr_delay_cycles = 1 }
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
set.toml:4:41: warning[AX442]: `antr.velocity_position_control_on` (P-AXIS-00265) is the predecessor of P-AXIS-00767, which takes its value
    write instead: antr.sai_op_mode_change.v_velocity_control_on = 299999
set.toml:4:81: warning[AX442]: `antr.velocity_position_control_off` (P-AXIS-00266) is the predecessor of P-AXIS-00768, which takes its value
    write instead: antr.sai_op_mode_change.v_position_control_on = 300000
set.toml:4:41: error[AX320]: `antr.velocity_position_control_on` (P-AXIS-00265) is 299999, below `antr.velocity_position_control_off` (P-AXIS-00266) with 300000
    allowed: v_velocity_control_on >= v_position_control_on [0.001 deg/s]
    write instead: both velocities, each at its own name: 200 rpm are 1200000
",
    );
}

#[test]
fn a_changeover_that_never_comes() {
    assert_transcript(
        said_of_axis,
        r"
> kenngr.achs_typ = 4
> antr.sai_op_mode_change.v_position_control_on = 300000
> antr.nbr_delay_cycles = 1
> getriebe = [{ kv = 20000, dynamik.vb_max = 18000000 }]
set.toml:4:49: warning[AX444]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is not given: its default is 200000000, and up to 33333.3 rpm the spindle stays in position control
    write instead: v_velocity_control_on with a speed of the spindle: 200 rpm are 1200000

> kenngr.achs_typ = 4
> antr.sai_op_mode_change.v_velocity_control_on = 18000000
> antr.nbr_delay_cycles = 1
> getriebe = [{ kv = 20000, dynamik.vb_max = 18000000 }]
set.toml:4:49: warning[AX444]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 18000000, and vb_max 18000000 (P-AXIS-00212) is not above it: the spindle stays in position control
    write instead: v_velocity_control_on with a speed of the spindle: 200 rpm are 1200000

> kenngr.achs_typ = 4
> antr.sai_op_mode_change.v_velocity_control_on = 17999999
> antr.nbr_delay_cycles = 1
> getriebe = [{ kv = 20000, dynamik.vb_max = 18000000 }]
",
    );
}

/// Kv, the largest velocity.
#[test]
fn what_nobody_gave() {
    assert_transcript(
        said_of_axis,
        r"
> kenngr.achs_typ = 4
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
set.toml:2:7: warning[AX440]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is not given: its default 200000 is the largest velocity of the spindle, 33.3333 rpm
    write instead: vb_max with the value of the machine
set.toml:2:7: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s
    write instead: the gain of the machine, in 0.01/s

> kenngr.achs_typ = 4
> kenngr.antr_typ = 'CANOPEN'
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
> antr.nbr_delay_cycles = 0
> getriebe = [{ dynamik.vb_max = 18000000 }]
set.toml:2:7: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s
    write instead: the gain of the machine, in 0.01/s
",
    );
}

#[test]
fn what_position_control_in_the_cnc_does_not_use() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> antr.sercos.op_mode_for_velocity_control = 1
> antr.canopen.cyclic_position_op_mode = -1
> antr.canopen.cyclic_velocity_op_mode = -1
> antr.sai_op_mode_change.feed_forward_v_weighting = 500
> antr.feed_forward_v_weighting = 500
> process_data.objects = []
> drive_settings = ['S-0-0032=3']
set.toml:3:44: warning[AX426]: without effect here: the changeover with position control in the CNC does not use P-AXIS-00264, drive_settings, P-AXIS-00463, P-AXIS-00464, P-AXIS-00833, P-AXIS-00766, process_data.objects

> antr.sercos.op_mode_for_velocity_control = 0
set.toml:3:44: warning[AX426]: without effect here: the changeover with position control in the CNC does not use P-AXIS-00264

> kenngr.antr_typ = 'SERCOS'
> antr.operation_mode = 'CNC_POSITION_CONTROL'
> antr.sai_op_mode_change.feed_forward_v_weighting = 500
set.toml:5:52: warning[AX426]: without effect here: the changeover with position control in the CNC does not use P-AXIS-00766
",
    );
}

#[test]
fn own_keys_are_judged_on_any_axis() {
    assert_transcript(
        said_of_axis,
        r"
> spindle.deceleration = 0
> getriebe = [{ kv = 2000 }]
set.toml:3:24: error[AX203]: `spindle.deceleration` is 0
    allowed: 0 < deceleration <= 1000000000000 [0.001 deg/s^2]

> spindle = { window = 0, takeover_window = 180000.1, mode_timeout = '0s', brake_timeout = '1001s' }
> process_data.objects = ['6060h', 'S-0-0037']
> drive_settings = 'S-0-0032=3'
set.toml:4:34: error[AX202]: `process_data.objects` is `S-0-0037`
    allowed: any of S-0-0036, S-0-0040, S-0-0047, S-0-0051, S-0-0053, 6060h (0x6060), 6061h (0x6061), 607Ah (0x607A), 6064h (0x6064), 60FFh (0x60FF), 606Ch (0x606C)
    write instead: S-0-0036
set.toml:5:18: error[AX204]: `drive_settings` is of type string
    allowed: an array of strings, any of S-0-0032=3, S-0-0033=2, S-0-0034=2, S-0-0035=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
set.toml:3:22: error[AX203]: `spindle.window` is 0
    allowed: 0 < window <= 2000000000 [0.001 deg/s]
set.toml:3:43: error[AX203]: `spindle.takeover_window` is 180000.1
    allowed: 0 < takeover_window <= 180000 [0.001 deg]
set.toml:3:68: error[AX203]: `spindle.mode_timeout` is 0s
    allowed: 1ns <= mode_timeout <= 1000s
set.toml:3:90: error[AX203]: `spindle.brake_timeout` is 1001s
    allowed: 0s <= brake_timeout <= 1000s

> spindle = { deceleration = 1000000000001.0, window = 2000000000.5, takeover_window = 0 }
> getriebe = [{ kv = 2000 }]
set.toml:3:28: error[AX203]: `spindle.deceleration` is 1000000000001
    allowed: 0 < deceleration <= 1000000000000 [0.001 deg/s^2]
set.toml:3:54: error[AX203]: `spindle.window` is 2000000000.5
    allowed: 0 < window <= 2000000000 [0.001 deg/s]
set.toml:3:86: error[AX203]: `spindle.takeover_window` is 0
    allowed: 0 < takeover_window <= 180000 [0.001 deg]
",
    );
}
