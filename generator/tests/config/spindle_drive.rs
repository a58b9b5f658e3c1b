//! A changeover in the drive, and one in a gantry: what is refused and warned of, to the letter.

use super::{assert_said, assert_transcript, canopen, in_cnc, said_of_axis, said_of_set, sercos};

#[test]
fn drives_of_which_nothing_is_said() {
    assert_transcript(
        |given| said_of_axis(&sercos(given)),
        r"
> # SERCOS

> antr.sercos.op_mode_for_velocity_control = 3
",
    );
}

#[test]
fn drives_that_do_not_change_their_mode() {
    assert_transcript(
        |given| said_of_axis(&canopen(given)),
        r#"
> kenngr.antr_typ = 'PROFIDRIVE'
> getriebe = [{ kv = 2000, incr_per_rev = 1024, dynamik.vb_max = 18000000 }]
set.toml:3:19: error[AX321]: the drive is PROFIDRIVE (P-AXIS-00020) and controls the position (P-AXIS-00320): it does not change its operation mode for the CNC
    allowed: SERCOS or CANOPEN, or position control in the CNC
    write instead: antr.operation_mode = "CNC_POSITION_CONTROL"

> kenngr.antr_typ = 'LIGHTBUS'
> antr.operation_mode = 'DRIVE_POSITION_CONTROL'
set.toml:4:23: error[AX321]: the drive is LIGHTBUS (P-AXIS-00020) and controls the position (P-AXIS-00320): it does not change its operation mode for the CNC
    allowed: SERCOS or CANOPEN, or position control in the CNC
    write instead: antr.operation_mode = "CNC_POSITION_CONTROL"

> kenngr.antr_typ = 'LIGHTBUS'

> kenngr.antr_typ = 'PROFIDRIVE'
> antr.operation_mode = 'CNC_POSITION_CONTROL'
"#,
    );
}

#[test]
fn operation_modes_of_sercos() {
    assert_transcript(
        |given| said_of_axis(&sercos(given)),
        r"
> antr.sercos.op_mode_for_velocity_control = 0
set.toml:3:44: error[AX322]: `antr.sercos.op_mode_for_velocity_control` (P-AXIS-00264) is 0, the main mode, which is that of position control: the drive's answer could not be told from the mode that it leaves
    allowed: 1, 2 or 3: an auxiliary mode of the drive (S-0-0033 to S-0-0035) with velocity control
    write instead: antr.sercos.op_mode_for_velocity_control = 1, if S-0-0033 is velocity control

> antr.sercos.op_mode_for_velocity_control = 4
set.toml:3:44: error[AX203]: `antr.sercos.op_mode_for_velocity_control` (P-AXIS-00264) is 4
    allowed: 0 (main mode, S-0-0032), 1 (auxiliary mode 1, S-0-0033), 2 (auxiliary mode 2, S-0-0034), 3 (auxiliary mode 3, S-0-0035)

> antr.canopen.cyclic_position_op_mode = 8
> antr.canopen.cyclic_velocity_op_mode = 9
set.toml:3:40: warning[AX426]: without effect here: the changeover with a SERCOS drive does not use P-AXIS-00463, P-AXIS-00464
",
    );
}

#[test]
fn operation_modes_of_canopen() {
    assert_transcript(
        |given| said_of_axis(&canopen(given)),
        r"
> antr.canopen.cyclic_position_op_mode = 9
set.toml:3:40: error[AX322]: `antr.canopen.cyclic_position_op_mode` (P-AXIS-00463) and `antr.canopen.cyclic_velocity_op_mode` (P-AXIS-00464) are both 9: the drive's answer could not be told from the mode that it leaves
    allowed: two operation modes (6060h)
    write instead: 8 for position control and 9 for velocity control

> antr.canopen.cyclic_velocity_op_mode = -3
> antr.canopen.cyclic_position_op_mode = -3
set.toml:3:40: error[AX322]: `antr.canopen.cyclic_position_op_mode` (P-AXIS-00463) and `antr.canopen.cyclic_velocity_op_mode` (P-AXIS-00464) are both -3: the drive's answer could not be told from the mode that it leaves
    allowed: two operation modes (6060h)
    write instead: 8 for position control and 9 for velocity control

> antr.canopen.cyclic_velocity_op_mode = -32768
> antr.canopen.cyclic_position_op_mode = 32767

> antr.canopen.cyclic_velocity_op_mode = -32769
> antr.canopen.cyclic_position_op_mode = 32768
set.toml:4:40: error[AX203]: `antr.canopen.cyclic_position_op_mode` (P-AXIS-00463) is 32768
    allowed: -32768 <= cyclic_position_op_mode <= 32767
set.toml:3:40: error[AX203]: `antr.canopen.cyclic_velocity_op_mode` (P-AXIS-00464) is -32769
    allowed: -32768 <= cyclic_velocity_op_mode <= 32767

> antr.sercos.op_mode_for_velocity_control = 1
> drive_settings = []
set.toml:3:44: warning[AX426]: without effect here: the changeover with a CANopen drive does not use P-AXIS-00264, drive_settings
",
    );
}

#[test]
fn what_a_sercos_drive_has() {
    assert_transcript(
        |given| said_of_axis(&sercos(given)),
        r#"
> process_data.objects = []
> drive_settings = []
set.toml:3:24: error[AX325]: `process_data.objects` has no S-0-0036, the velocity command: the changeover needs it
    allowed: S-0-0036, S-0-0040, S-0-0047, S-0-0051 or S-0-0053
    write instead: "S-0-0036" in process_data.objects, if the drive has it
set.toml:3:24: error[AX325]: `process_data.objects` has no S-0-0040, the actual velocity: the changeover needs it
    allowed: S-0-0036, S-0-0040, S-0-0047, S-0-0051 or S-0-0053
    write instead: "S-0-0040" in process_data.objects, if the drive has it
set.toml:3:24: error[AX325]: `process_data.objects` has no S-0-0047, the position command: the changeover needs it
    allowed: S-0-0036, S-0-0040, S-0-0047, S-0-0051 or S-0-0053
    write instead: "S-0-0047" in process_data.objects, if the drive has it
set.toml:3:24: error[AX325]: `process_data.objects` has no S-0-0051 or S-0-0053, the actual position: the changeover needs it
    allowed: S-0-0036, S-0-0040, S-0-0047, S-0-0051 or S-0-0053
    write instead: "S-0-0051" in process_data.objects, if the drive has it
set.toml:4:18: error[AX325]: `drive_settings` has no S-0-0032=3, position control in the main mode: the changeover needs it
    allowed: S-0-0032=3, S-0-0033=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
    write instead: "S-0-0032=3" in drive_settings, if the drive has it
set.toml:4:18: error[AX325]: `drive_settings` has no S-0-0033=2, velocity control in the auxiliary mode 1: the changeover needs it
    allowed: S-0-0032=3, S-0-0033=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
    write instead: "S-0-0033=2" in drive_settings, if the drive has it
set.toml:4:18: error[AX325]: `drive_settings` has no S-0-0076=010, rotary scaling of positions: the changeover needs it
    allowed: S-0-0032=3, S-0-0033=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
    write instead: "S-0-0076=010" in drive_settings, if the drive has it
set.toml:4:18: error[AX325]: `drive_settings` has no S-0-0044=010, rotary scaling of velocities: the changeover needs it
    allowed: S-0-0032=3, S-0-0033=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
    write instead: "S-0-0044=010" in drive_settings, if the drive has it
set.toml:4:18: error[AX325]: `drive_settings` has no S-0-0160=010, rotary scaling of accelerations: the changeover needs it
    allowed: S-0-0032=3, S-0-0033=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
    write instead: "S-0-0160=010" in drive_settings, if the drive has it

> process_data.objects = ['S-0-0036', 'S-0-0040', 'S-0-0047', 'S-0-0053']
> drive_settings = ['S-0-0032=3', 'S-0-0033=2', 'S-0-0034=2', 'S-0-0076=010', 's-0-0044=010', 'S-0-0160=010']

> antr.sercos.op_mode_for_velocity_control = 2
> drive_settings = ['S-0-0032=3', 'S-0-0033=2', 'S-0-0076=010', 'S-0-0044=010', 'S-0-0160=010']
set.toml:4:18: error[AX325]: `drive_settings` has no S-0-0034=2, velocity control in the auxiliary mode 2: the changeover needs it
    allowed: S-0-0032=3, S-0-0034=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
    write instead: "S-0-0034=2" in drive_settings, if the drive has it

> antr.sercos.op_mode_for_velocity_control = 3
> drive_settings = ['S-0-0032=3', 'S-0-0033=2', 'S-0-0076=010', 'S-0-0044=010', 'S-0-0160=010']
set.toml:4:18: error[AX325]: `drive_settings` has no S-0-0035=2, velocity control in the auxiliary mode 3: the changeover needs it
    allowed: S-0-0032=3, S-0-0035=2, S-0-0076=010, S-0-0044=010, S-0-0160=010
    write instead: "S-0-0035=2" in drive_settings, if the drive has it
"#,
    );
}

#[test]
fn what_a_canopen_drive_has() {
    assert_transcript(
        |given| said_of_axis(&canopen(given)),
        r#"
> process_data.objects = ['6060h', '6061h']
set.toml:3:24: error[AX325]: `process_data.objects` has no 607Ah, the position command: the changeover needs it
    allowed: 6060h, 6061h, 607Ah, 6064h, 60FFh, 606Ch
    write instead: "607Ah" in process_data.objects, if the drive has it
set.toml:3:24: error[AX325]: `process_data.objects` has no 6064h, the actual position: the changeover needs it
    allowed: 6060h, 6061h, 607Ah, 6064h, 60FFh, 606Ch
    write instead: "6064h" in process_data.objects, if the drive has it
set.toml:3:24: error[AX325]: `process_data.objects` has no 60FFh, the velocity command: the changeover needs it
    allowed: 6060h, 6061h, 607Ah, 6064h, 60FFh, 606Ch
    write instead: "60FFh" in process_data.objects, if the drive has it
set.toml:3:24: error[AX325]: `process_data.objects` has no 606Ch, the actual velocity: the changeover needs it
    allowed: 6060h, 6061h, 607Ah, 6064h, 60FFh, 606Ch
    write instead: "606Ch" in process_data.objects, if the drive has it

> process_data.objects = ['0x6060', '6061H', '607ah', '6064h', '60FFh', '606Ch', 'S-0-0036']
"#,
    );
}

#[test]
fn the_delay_must_be_written() {
    assert_transcript(
        said_of_axis,
        r"
> kenngr.achs_typ = 4
> kenngr.antr_typ = 'CANOPEN'
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
set.toml:2:7: error[AX206]: `antr.nbr_delay_cycles` (P-AXIS-00191) is missing: the position command at the change to position control needs the cycles between a command and the actual value that it causes
    allowed: 0 <= nbr_delay_cycles <= 10 [cycles]
    write instead: antr.nbr_delay_cycles with the cycles of the bus, both ways together

> kenngr.achs_typ = 4
> kenngr.antr_typ = 'CANOPEN'
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
> antr.nbr_delay_cycles = 11
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
set.toml:6:25: error[AX203]: `antr.nbr_delay_cycles` (P-AXIS-00191) is 11
    allowed: 0 <= nbr_delay_cycles <= 10 [cycles]

> kenngr.achs_typ = 4
> kenngr.antr_typ = 'CANOPEN'
> antr.sai_op_mode_change.v_velocity_control_on = 1200000
> antr.nbr_delay_cycles = 10
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
",
    );
}

/// Conventional feedforward steps; an additive velocity comes twice; the drive's own is what a changeover counts.
#[test]
fn feedforward() {
    assert_transcript(
        |given| said_of_axis(&sercos(given)),
        r"
> vorsteuer.vorsteuerung = 'VEL ACC'
set.toml:3:26: error[AX329]: `vorsteuer.vorsteuerung` (P-AXIS-00223) is VEL ACC: it leads the position command of the drive, which would step at the changeover
    allowed: NONE, or quantities with an additive output: ADD_VEL, ADD_ACC
    write instead: ADD_VEL, or NONE and the feedforward of the drive (SERCOS S-0-0296, CANopen 3062h; P-AXIS-00833)

> vorsteuer = { vorsteuerung = 'VEL', global_disable = true }
set.toml:3:54: warning[AX429]: vorsteuer.global_disable (P-AXIS-00256) is TRUE: feedforward puts out 0, despite G135
    write instead: FALSE, or NONE in vorsteuer.vorsteuerung

> vorsteuer.vorsteuerung = 'ADD_VEL'
> process_data.additive_velocity = 'INT32'
set.toml:3:26: warning[AX445]: `vorsteuer.vorsteuerung` (P-AXIS-00223) has ADD_VEL: beside the block spindle the drive would get the velocity twice in velocity control, where spindle_axis puts out none, and the change to position control does not count it
    write instead: G137 while `loop_closed` is FALSE, or the feedforward of the drive (P-AXIS-00833)

> vorsteuer.vorsteuerung = 'ADD_VEL'
> process_data.additive_velocity = 'INT32'
> antr.sai_op_mode_change.feed_forward_v_weighting = 500
set.toml:5:52: warning[AX423]: the drive feeds 50 % of the velocity forward itself (P-AXIS-00766), and the CNC does too: the axis leads
    write instead: feedforward in one of the two: in the drive its gains are S-0-0296 (velocity) and S-0-0348 (acceleration)
set.toml:3:26: warning[AX445]: `vorsteuer.vorsteuerung` (P-AXIS-00223) has ADD_VEL: beside the block spindle the drive would get the velocity twice in velocity control, where spindle_axis puts out none, and the change to position control does not count it
    write instead: G137 while `loop_closed` is FALSE, or the feedforward of the drive (P-AXIS-00833)

> antr.feed_forward_v_weighting = 1000
> antr.sai_op_mode_change.feed_forward_v_weighting = 500
set.toml:4:52: warning[AX446]: `antr.sai_op_mode_change.feed_forward_v_weighting` (P-AXIS-00766) is 500, and `antr.feed_forward_v_weighting` (P-AXIS-00833), which replaces it, is 1000: 1000 holds
    write instead: only P-AXIS-00833

> antr.feed_forward_v_weighting = 1200
> antr.sai_op_mode_change.feed_forward_v_weighting = 1200

> antr.feed_forward_v_weighting = 1201
set.toml:3:33: error[AX203]: `antr.feed_forward_v_weighting` (P-AXIS-00833) is 1201
    allowed: 0 <= feed_forward_v_weighting <= 1200 [0.1 %]

> antr.sai_op_mode_change.feed_forward_v_weighting = 1201
set.toml:3:52: error[AX203]: `antr.sai_op_mode_change.feed_forward_v_weighting` (P-AXIS-00766) is 1201
    allowed: 0 <= feed_forward_v_weighting <= 1200 [0.1 %]
",
    );
}

#[test]
fn feedforward_in_the_cnc() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> vorsteuer = { vorsteuerung = 'VEL', vs_v_faktor = 8, vs_v_nenner = 10 }

> vorsteuer.vorsteuerung = 'ADD_VEL'
> process_data.additive_velocity = 'INT32'
set.toml:3:26: warning[AX445]: `vorsteuer.vorsteuerung` (P-AXIS-00223) has ADD_VEL: beside the block spindle the drive would get the velocity twice in velocity control, where spindle_axis puts out none
    write instead: G137 while `loop_closed` is FALSE, or VEL

> vorsteuer = { vorsteuerung = 'ADD_VEL', default_active = true }
> process_data.additive_velocity = 'INT32'
set.toml:3:30: warning[AX445]: `vorsteuer.vorsteuerung` (P-AXIS-00223) has ADD_VEL: beside the block spindle the drive would get the velocity twice in velocity control, where spindle_axis puts out none
    write instead: vorsteuer.default_active FALSE, and G137 while `loop_closed` is FALSE, or VEL
",
    );
}

#[test]
fn the_velocity_command() {
    assert_transcript(
        |given| said_of_axis(&sercos(given)),
        r"
> antr.v_reso_num = 0
set.toml:3:19: error[AX330]: `antr.v_reso_num` (P-AXIS-00206) is 0: the velocity command of the drive is always 0
    allowed: 1 <= v_reso_num [increments]
    write instead: v_reso_num with the scaling of the drive

> antr.v_reso_num = 100000
> antr.v_reso_denom = 1
set.toml:3:19: warning[AX435]: the velocity command at vb_max, 18000000 0.001 deg/s, is 108000000000000 increments, and INT32 ends at 2147483647: it saturates at 357.914 0.001 deg/s
    write instead: a scaling with fewer increments

> process_data.velocity_command = 'INT16'
set.toml:3:33: warning[AX435]: the velocity command at vb_max, 18000000 0.001 deg/s, is 30000000 increments, and INT16 ends at 32767: it saturates at 19660.2 0.001 deg/s
    write instead: INT32, if the drive has it, or a scaling with fewer increments

> process_data.velocity_command = 'INT16'
> antr.v_time_base = 1
> antr.v_reso_denom = 1000
",
    );
}

#[test]
fn a_gantry_slave() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> kopf.achs_nr = 2
> kenngr.gantry_ax_nr = 1
set.toml:4:23: error[AX328]: a gantry slave (P-AXIS-00070) follows its master's position, and cannot change to velocity control
    write instead: no gantry, or no P-AXIS-00767 and P-AXIS-00768
",
    );
}

#[test]
fn a_gantry_master() {
    let set = format!(
        "cycle_time = '1ms'\n[axis.M]\nkopf.achs_nr = 1\n{}\n[axis.N]\nkopf.achs_nr = 2\nkenngr.gantry_ax_nr = 1\n\
         kenngr.achs_typ = 4\ngetriebe = [{{ kv = 10000, multi_gain_z = 10000000, multi_gain_n = 360 }}]\n",
        in_cnc("# master")
    );
    assert_said(
        &said_of_set(&set),
        &[
            "set.toml:13:23: error[AX328]: N follows M, which changes to velocity control (P-AXIS-00767, 00768)",
            "    write instead: no gantry, or no P-AXIS-00767 and P-AXIS-00768 of the master",
        ],
    );
}
