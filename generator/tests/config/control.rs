//! Feedforward, position control, gantries: what is refused, corrected and warned of, to the letter.

use super::{IPC, assert_said, assert_transcript, direct, read_list, said, said_of_axis, said_of_set};

#[test]
fn where_the_position_is_controlled() {
    assert_transcript(
        said_of_axis,
        r#"
> kenngr.antr_typ = 2
> ipc.enable = 'ON'
> ipc.v_add_max_fact = 1
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:4:45: error[AX310]: improved position control is enabled, the drive controls the position (SERCOS, P-AXIS-00020), and its process data have no additive velocity
    allowed: an additive velocity command in the process data: SERCOS S-0-0037, CANopen 60B1h, PROFIdrive NSOLL_B
    write instead: process_data.additive_velocity = "INT32" in a set, if the drive has it, or antr.operation_mode CNC_POSITION_CONTROL (P-AXIS-00320)

> kenngr.antr_typ = 'CANOPEN'
> ipc.v_add_max_fact = 1
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:2:7: warning[AX432]: improved position control is configured, the drive controls the position (CANOPEN, P-AXIS-00020), and its process data have no additive velocity
    allowed: an additive velocity command in the process data: SERCOS S-0-0037, CANopen 60B1h, PROFIdrive NSOLL_B
    write instead: process_data.additive_velocity = "INT32" in a set, if the drive has it, or antr.operation_mode CNC_POSITION_CONTROL (P-AXIS-00320)

> kenngr.antr_typ = 3
> ipc.enable = 'ON'
> process_data.additive_velocity = 'INT32'
> ipc.v_add_max_fact = 1
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:2:7: warning[AX440]: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is not given: its default 200000 sets the limit |v_add| <= 200 um/s
    write instead: vb_max with the value of the machine
set.toml:2:7: warning[AX440]: `getriebe[0].incr_per_rev` (P-AXIS-00092) is not given: its default 1024 scales the control deviation XERR
    write instead: incr_per_rev with the value of the machine

> kenngr.antr_typ = 2
> antr.operation_mode = 'CNC_POSITION_CONTROL'
> getriebe = [{ kv = 2000, dynamik.vb_max = 200000 }]
> ipc.enable = 'ON'
> ipc.v_add_max_fact = 1
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
"#,
    );
}

#[test]
fn what_feedforward_refuses() {
    assert_transcript(
        said_of_axis,
        r#"
> vorsteuer.vorsteuerung = 'ADD_JERK'
set.toml:3:26: error[AX311]: `vorsteuer.vorsteuerung` (P-AXIS-00223) has ADD_JERK, whose formula no document gives
    allowed: VEL, ACC, JERK, ADD_VEL, ADD_ACC
    write instead: JERK, or add_jerk = "experimental" in a set, to try a formula that is inferred from units

> vorsteuer.vorsteuerung = 0x804
> vorsteuer.jerk_fact_denom = 2
> getriebe = [{ kv = 2000, load = 0.1 }]
> add_jerk = 'experimental'
> process_data.additive_torque = 'INT16'

> vorsteuer.vorsteuerung = 'VEL ACC'
> vorsteuer.vs_a_faktor = 4000
> vorsteuer.feedforward_without_delay = true
> getriebe = [{ kv = 2000 }]
set.toml:5:39: error[AX312]: `vorsteuer.feedforward_without_delay` (P-AXIS-00566) is TRUE beside VEL ACC: error 110624 of the controller
    allowed: VEL alone in vorsteuer.vorsteuerung (P-AXIS-00223)
    write instead: feedforward_without_delay FALSE, or VEL alone

> vorsteuer.vorsteuerung = 'VEL'
> vorsteuer.feedforward_without_delay = 1
> getriebe = [{ kv = 2000 }]

> vorsteuer.vorsteuerung = 'ADD_ACC'
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1, incr_per_rev = 0 }]
set.toml:5:53: error[AX313]: `getriebe[0].incr_per_rev` (P-AXIS-00092) is 0, and the additive torque needs it
    allowed: 1 <= incr_per_rev [increments/revolution]

> kenngr.antr_typ = 'PROFIDRIVE'
> antr.feed_const_num = 50000
> getriebe = [{ kv = 2000, incr_per_rev = 0 }]
> vorsteuer.vorsteuerung = 'VEL'
set.toml:5:41: error[AX313]: `getriebe[0].incr_per_rev` (P-AXIS-00092) is 0, and with the feed constant 50000/1 (P-AXIS-00362/00363) the control deviation XERR is always 0
    allowed: 1 <= incr_per_rev [increments/revolution]

> kenngr.antr_typ = 'PROFIDRIVE'
> getriebe = [{ kv = 2000, incr_per_rev = 0 }]
> vorsteuer.vorsteuerung = 'VEL'
set.toml:2:7: warning[AX440]: `vorsteuer.shift_time` (P-AXIS-00165) is not given: its default 3 shifts the position behind the feedforward
    write instead: shift_time with the value of the machine

> vorsteuer.vorsteuerung = 'ADD_ACC'
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 1e300 }]
set.toml:5:33: error[AX314]: the scaling of the additive torque is 6.135923151542565e298: a sample in range times it is beyond the numbers of this axis
    write instead: the scaling of the drive's manual

> vorsteuer.vorsteuerung = 'ADD_ACC'
> process_data.additive_torque = 'INT16'
> motor = 'linear'
> kenngr.achs_typ = 2
> getriebe = [{ kv = 2000, load = 100 }]
set.toml:5:9: error[AX316]: `motor` is linear, and the axis turns (P-AXIS-00018)
    write instead: motor = "rotary"
"#,
    );
}

#[test]
fn what_is_corrected() {
    assert_transcript(
        said_of_axis,
        r#"
> vorsteuer.vorsteuerung = 'ADD_VEL'
> getriebe = [{ kv = 2000 }]
set.toml:3:26: warning[AX414]: `vorsteuer.vorsteuerung` (P-AXIS-00223) has ADD_VEL, and the process data have no such command: error 70350 of the controller; the output is switched off
    write instead: process_data.additive_velocity = "INT32" or "INT16" in a set, if the drive has it

> vorsteuer.vorsteuerung = 'VEL ADD_ACC'
> getriebe = [{ kv = 2000 }]
set.toml:3:26: warning[AX415]: `vorsteuer.vorsteuerung` (P-AXIS-00223) has ADD_ACC, and the process data have no such command: error 70351 of the controller; the output is switched off
    write instead: process_data.additive_torque = "INT32" or "INT16" in a set, if the drive has it

> vorsteuer.vorsteuerung = 'ADD_VEL'
> vorsteuer.velocity_delay_time = 6000
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000 }]
set.toml:4:33: warning[AX416]: `vorsteuer.velocity_delay_time` (P-AXIS-00389) is 6000 us: error 70349 of the controller; the delay is corrected to 0
    allowed: 0 <= velocity_delay_time < 6 cycles, 1ms each [us]

> vorsteuer.vorsteuerung = 'ADD_VEL'
> vorsteuer.velocity_delay_time = 5999
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000 }]

> vorsteuer.vorsteuerung = 'ADD_ACC'
> vorsteuer.acceleration_delay_time = 70000
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:4:37: warning[AX417]: `vorsteuer.acceleration_delay_time` (P-AXIS-00390) is 70000 us: error 70348 of the controller; the delay is corrected to 0
    allowed: 0 <= acceleration_delay_time < 6 cycles, 1ms each [us]

> vorsteuer.vorsteuerung = 'ADD_ACC'
> vorsteuer.acceleration_delay_time = -1
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:4:37: warning[AX417]: `vorsteuer.acceleration_delay_time` (P-AXIS-00390) is -1 us: error 70348 of the controller; the delay is corrected to 0
    allowed: 0 <= acceleration_delay_time < 6 cycles, 1ms each [us]

> vorsteuer.vorsteuerung = 'ADD_JERK'
> vorsteuer.jerk_delay_time = 6000
> vorsteuer.jerk_fact_denom = 2
> add_jerk = 'experimental'
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:4:29: warning[AX417]: `vorsteuer.jerk_delay_time` (P-AXIS-00547) is 6000 us: error 70348 of the controller; the delay is corrected to 0
    allowed: 0 <= jerk_delay_time < 6 cycles, 1ms each [us]

> vorsteuer.vorsteuerung = 'ADD_ACC'
> antr.torque_scale_denom = 0
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:4:27: warning[AX418]: `antr.torque_scale_denom` (P-AXIS-00326) is 0: error 110465 of the controller; the additive torque is switched off
    allowed: 1 <= torque_scale_denom

> vorsteuer.vorsteuerung = 'JERK'
> vorsteuer.vs_a_faktor = 4000
> vorsteuer.jerk_fact_denom = 0
> getriebe = [{ kv = 2000 }]
set.toml:5:29: warning[AX419]: `vorsteuer.jerk_fact_denom` (P-AXIS-00338) is 0: error 110473 of the controller; it is corrected to 100
    allowed: 1 <= jerk_fact_denom

> vorsteuer.vorsteuerung = 'VEL ACC'
> vorsteuer.vs_a_nenner = 0
> vorsteuer.vs_v_nenner = 0
> getriebe = [{ kv = 2000 }]
set.toml:5:25: warning[AX420]: `vorsteuer.vs_v_nenner` (P-AXIS-00229) is 0: feedforward is left out
    allowed: 1 <= vs_v_nenner
set.toml:4:25: warning[AX420]: `vorsteuer.vs_a_nenner` (P-AXIS-00226) is 0: the acceleration is left out
    allowed: 1 <= vs_a_nenner

> vorsteuer.vorsteuerung = 'ACC JERK'
> vorsteuer.vs_a_nenner = 0
> vorsteuer.jerk_fact_denom = 2
> getriebe = [{ kv = 2000 }]
set.toml:4:25: warning[AX420]: `vorsteuer.vs_a_nenner` (P-AXIS-00226) is 0: the acceleration, and the jerk that shares its time constant, are left out
    allowed: 1 <= vs_a_nenner
set.toml:5:29: warning[AX426]: nothing of what this axis does uses P-AXIS-00338

> vorsteuer.vorsteuerung = 'JERK'
> vorsteuer.vs_a_nenner = 0
> vorsteuer.jerk_fact_denom = 2
> getriebe = [{ kv = 2000 }]
set.toml:4:25: warning[AX420]: `vorsteuer.vs_a_nenner` (P-AXIS-00226) is 0: the jerk, which has the time constant of the acceleration, is left out
    allowed: 1 <= vs_a_nenner
set.toml:5:29: warning[AX426]: nothing of what this axis does uses P-AXIS-00338

> vorsteuer.vorsteuerung = 'ADD_ACC ADD_JERK'
> vorsteuer.vs_a_nenner = 0
> vorsteuer.jerk_fact_denom = 2
> add_jerk = 'experimental'
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:4:25: warning[AX420]: `vorsteuer.vs_a_nenner` (P-AXIS-00226) is 0: the acceleration is left out
    allowed: 1 <= vs_a_nenner

> vorsteuer.vorsteuerung = 'ADD_ACC'
> antr.acc_reference_value = 0
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:4:28: warning[AX421]: `antr.acc_reference_value` (P-AXIS-00392) is 0: the additive torque is switched off
    write instead: the nominal torque of the motor, from its data sheet
"#,
    );
}

#[test]
fn what_is_inert_or_dangerous() {
    assert_transcript(
        said_of_axis,
        r#"
> vorsteuer.vorsteuerung = 'ACC JERK'
> getriebe = [{ kv = 2000 }]
set.toml:3:26: warning[AX422]: the time constant of the acceleration (P-AXIS-00225/00226) has its default, 1 us
    write instead: vorsteuer.vs_a_faktor with the drive's time constant in us
set.toml:3:26: warning[AX422]: the factor of the jerk (P-AXIS-00337/00338) has its default, 1/100
    write instead: vorsteuer.jerk_fact_num and jerk_fact_denom: 1/2 for a drive that only delays

> vorsteuer.vorsteuerung = 'ADD_ACC'
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000 }]
set.toml:3:26: warning[AX422]: getriebe[0].load (P-AXIS-00391) has its default, 1e-6
    write instead: the inertia of motor and load in kg m^2, of a linear motor the mass in kg

> kenngr.antr_typ = 2
> vorsteuer.vorsteuerung = 'VEL'
> antr.feed_forward_v_weighting = 500
> getriebe = [{ kv = 2000 }]
set.toml:5:33: warning[AX423]: the drive feeds 50 % of the velocity forward itself (P-AXIS-00833), and the CNC does too: the axis leads
    write instead: feedforward in one of the two: in the drive its gains are S-0-0296 (velocity) and S-0-0348 (acceleration)

> kenngr.antr_typ = 'CANOPEN'
> vorsteuer.vorsteuerung = 'VEL'
> antr.sai_op_mode_change.feed_forward_v_weighting = 1000
> getriebe = [{ kv = 2000 }]
set.toml:5:52: warning[AX423]: the drive feeds 100 % of the velocity forward itself (P-AXIS-00766), and the CNC does too: the axis leads
    write instead: feedforward in one of the two: in the drive its weight is 3062h

> antr.operation_mode = 'DRIVE_POSITION_CONTROL'
> vorsteuer.vorsteuerung = 'VEL'
> antr.feed_forward_v_weighting = 500
> getriebe = [{ kv = 2000 }]
set.toml:5:33: warning[AX423]: the drive feeds 50 % of the velocity forward itself (P-AXIS-00833), and the CNC does too: the axis leads
    write instead: feedforward in one of the two

> vorsteuer.vorsteuerung = 'VEL'
> vorsteuer.vs_v_faktor = 12
> vorsteuer.vs_v_nenner = 10
> getriebe = [{ kv = 2000 }]
set.toml:4:25: warning[AX424]: feedforward has the weight 12/10 = 1.2 (P-AXIS-00228/00229): above 1 the axis leads its command
    write instead: 0.7 to 1

> vorsteuer.vorsteuerung = 'JERK ADD_ACC'
> vorsteuer.vs_a_faktor = 12
> vorsteuer.vs_a_nenner = 10
> vorsteuer.jerk_fact_denom = 2
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:3:26: warning[AX425]: vorsteuer.vs_a_faktor/vs_a_nenner (P-AXIS-00225/00226) is 1.2: a weight of ADD_ACC, and a time constant in us of JERK
    write instead: ADD_ACC without JERK, or ACC with JERK

> vorsteuer.vorsteuerung = 'VEL'
> vorsteuer.vs_a_faktor = 4000
> vorsteuer.velocity_delay_time = 150
> vorsteuer.shift_time = 2
> motor = 'rotary'
> getriebe = [{ kv = 2000 }]
set.toml:4:25: warning[AX426]: nothing of what this axis does uses P-AXIS-00225, P-AXIS-00389, P-AXIS-00165, motor

> vorsteuer.vorsteuerung = 'VEL'
> vorsteuer.global_disable = 'TRUE'
> getriebe = [{ kv = 2000 }]
set.toml:4:28: warning[AX429]: vorsteuer.global_disable (P-AXIS-00256) is TRUE: feedforward puts out 0, despite G135
    write instead: FALSE, or NONE in vorsteuer.vorsteuerung

> real = 'f32'
> getriebe = [{ kv = 2000 }]

> real = 'f32'
> kenngr.antr_typ = 8
> vorsteuer.vorsteuerung = 'VEL'
set.toml:2:7: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s
    write instead: the gain of the machine, in 0.01/s
set.toml:3:8: warning[AX430]: the drive's position command is computed in single precision, which has 24 bits for a position
    write instead: real = "f64" for this axis

> vorsteuer.vorsteuerung = 'VEL'
set.toml:2:7: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s
    write instead: the gain of the machine, in 0.01/s

> vorsteuer.vorsteuerung = 'VEL VEL'
set.toml:3:26: error[AX107]: `vorsteuer.vorsteuerung` (P-AXIS-00223) names `VEL` twice
    allowed: NONE (0x000), VEL (0x001), ACC (0x002), JERK (0x004), ADD_VEL (0x101), ADD_ACC (0x202), ADD_JERK (0x804), and sums of these
"#,
    );
}

#[test]
fn the_word_of_feedforward_and_the_drive() {
    assert_transcript(
        said_of_axis,
        r#"
> vorsteuer.vorsteuerung = 'VEL ADD_POS'
set.toml:3:26: error[AX202]: `vorsteuer.vorsteuerung` (P-AXIS-00223) is `ADD_POS`
    allowed: NONE (0x000), VEL (0x001), ACC (0x002), JERK (0x004), ADD_VEL (0x101), ADD_ACC (0x202), ADD_JERK (0x804), and sums of these

> vorsteuer.vorsteuerung = 0x400
set.toml:3:26: error[AX202]: `vorsteuer.vorsteuerung` (P-AXIS-00223) is `1024`: the bits 0x400 stand for nothing alone
    allowed: NONE (0x000), VEL (0x001), ACC (0x002), JERK (0x004), ADD_VEL (0x101), ADD_ACC (0x202), ADD_JERK (0x804), and sums of these
    write instead: 0x804, if ADD_JERK is meant

> vorsteuer.vorsteuerung = '0x405'
set.toml:3:26: error[AX202]: `vorsteuer.vorsteuerung` (P-AXIS-00223) is `0x405`: the bits 0x400 stand for nothing alone
    allowed: NONE (0x000), VEL (0x001), ACC (0x002), JERK (0x004), ADD_VEL (0x101), ADD_ACC (0x202), ADD_JERK (0x804), and sums of these
    write instead: 0x805, if ADD_JERK is meant

> vorsteuer.vorsteuerung = 0x3000
set.toml:3:26: error[AX202]: `vorsteuer.vorsteuerung` (P-AXIS-00223) is `12288`: the bits 0x3000 stand for nothing alone
    allowed: NONE (0x000), VEL (0x001), ACC (0x002), JERK (0x004), ADD_VEL (0x101), ADD_ACC (0x202), ADD_JERK (0x804), and sums of these

> vorsteuer.vorsteuerung = 0x100
set.toml:3:26: error[AX202]: `vorsteuer.vorsteuerung` (P-AXIS-00223) is `256`: the bits 0x100 stand for nothing alone
    allowed: NONE (0x000), VEL (0x001), ACC (0x002), JERK (0x004), ADD_VEL (0x101), ADD_ACC (0x202), ADD_JERK (0x804), and sums of these
    write instead: 0x101, if ADD_VEL is meant

> vorsteuer.vorsteuerung = -1
set.toml:3:26: error[AX202]: `vorsteuer.vorsteuerung` (P-AXIS-00223) is `-1`, which has a sign
    allowed: NONE (0x000), VEL (0x001), ACC (0x002), JERK (0x004), ADD_VEL (0x101), ADD_ACC (0x202), ADD_JERK (0x804), and sums of these

> vorsteuer.vorsteurung = 'VEL'
set.toml:3:11: error[AX104]: `vorsteuer.vorsteurung` is not known
    write instead: vorsteuer.vorsteuerung

> kenngr.antr_typ = 9
> getriebe = [{ kv = 0 }]
set.toml:3:19: error[AX202]: `kenngr.antr_typ` (P-AXIS-00020) is `9`
    allowed: CONVENTIONAL (ANTR_TYP_KONV, 1), SERCOS (ANTR_TYP_SERCOS, 2), PROFIDRIVE (ANTR_TYP_PROFIDRIVE, 3), SIMULATION (ANTR_TYP_SIMU, 4), LIGHTBUS (ANTR_TYP_LIGHTBUS, 5), TERMINAL (ANTR_TYP_TERM, 6), RT_ETHERNET (ANTR_TYP_ETHERNET, 7), CANOPEN (ANTR_TYP_CANOPEN, 8), VIRTUAL (ANTR_TYP_VIRTUELL, 16), CAN_BUS (ANTR_TYP_CAN, 32)
set.toml:4:20: error[AX203]: `getriebe[0].kv` (P-AXIS-00099) is 0
    allowed: 1 <= kv <= 4294967295 [0.01/s]

> kenngr.antr_typ = 'NOBODY'
> getriebe = [{ load = 'heavy' }]
> vorsteuer.vs_a_nenner = 'no number'
set.toml:3:19: error[AX202]: `kenngr.antr_typ` (P-AXIS-00020) is `NOBODY`
    allowed: CONVENTIONAL (ANTR_TYP_KONV, 1), SERCOS (ANTR_TYP_SERCOS, 2), PROFIDRIVE (ANTR_TYP_PROFIDRIVE, 3), SIMULATION (ANTR_TYP_SIMU, 4), LIGHTBUS (ANTR_TYP_LIGHTBUS, 5), TERMINAL (ANTR_TYP_TERM, 6), RT_ETHERNET (ANTR_TYP_ETHERNET, 7), CANOPEN (ANTR_TYP_CANOPEN, 8), VIRTUAL (ANTR_TYP_VIRTUELL, 16), CAN_BUS (ANTR_TYP_CAN, 32)
set.toml:4:22: error[AX204]: `getriebe[0].load` (P-AXIS-00391) is of type string
    allowed: a number, 0 <= load <= 1.7976931348623157e308 [kg m^2, linear motor: kg]
set.toml:5:25: error[AX204]: `vorsteuer.vs_a_nenner` (P-AXIS-00226) is of type string
    allowed: a whole number, 0 <= vs_a_nenner <= 2147483647
"#,
    );
}

/// Words with blanks or bars between, the number, in lists and in sets: one canonical form.
#[test]
fn every_spelling_of_the_mode() {
    let canonical = |mode: &str| {
        let (set, report) =
            read_list(format!("vorsteuer.vorsteuerung {mode}\nvorsteuer.vs_a_faktor 4000\ngetriebe[0].kv 2000"));
        set.unwrap_or_else(|| panic!("{mode}: {report}")).axes[0].axis.canonical.clone()
    };
    for mode in ["VEL|ACC", "ACC VEL", "acc | vel", "3", "0x3", "0x0003", "NONE VEL ACC"] {
        assert_eq!(canonical(mode), canonical("VEL ACC"), "{mode}");
    }
    assert!(canonical("VEL ACC").contains("vorsteuer.vorsteuerung VEL ACC\n"));
    assert_eq!(canonical("NONE"), canonical("0"));
}

/// A real machine's list has these for other functions: what they hold matters where a block uses it.
#[test]
fn what_nothing_uses_is_not_judged() {
    let drive = "kenngr.antr_typ NOBODY\nantr.operation_mode 17\nantr.v_reso_num none\nvorsteuer.vs_a_nenner -5\ngetriebe[0].load heavy";
    let (set, report) = read_list(drive);
    assert!(set.is_some(), "{report}");
    let (set, report) = read_list(format!("{drive}\n{IPC}stage[0].mode NOT_ACTIVE\nvorsteuer.vorsteuerung NONE"));
    assert!(set.is_some(), "{report}");
    assert_said(
        &said("kenngr.antr_typ NOBODY\ngetriebe[0].kv 2000"),
        &[
            "x.lis:1:17: error[AX202]: `kenngr.antr_typ` (P-AXIS-00020) is `NOBODY`",
            "    allowed: CONVENTIONAL (ANTR_TYP_KONV, 1), SERCOS (ANTR_TYP_SERCOS, 2), PROFIDRIVE (ANTR_TYP_PROFIDRIVE, 3), \
             SIMULATION (ANTR_TYP_SIMU, 4), LIGHTBUS (ANTR_TYP_LIGHTBUS, 5), TERMINAL (ANTR_TYP_TERM, 6), RT_ETHERNET \
             (ANTR_TYP_ETHERNET, 7), CANOPEN (ANTR_TYP_CANOPEN, 8), VIRTUAL (ANTR_TYP_VIRTUELL, 16), CAN_BUS (ANTR_TYP_CAN, 32)",
        ],
    );
}

/// Six cycles of 20 ms are longer than the delay's own type UNS16.
#[test]
fn a_delay_beyond_its_type() {
    let say = |given: &str| said_of_set(&format!("cycle_time = '20ms'\n[axis.X]\n{given}"));
    assert_transcript(
        say,
        r"
> vorsteuer = { vorsteuerung = 'ADD_VEL', velocity_delay_time = 65536 }
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000 }]
set.toml:3:63: error[AX203]: `vorsteuer.velocity_delay_time` (P-AXIS-00389) is 65536
    allowed: 0 <= velocity_delay_time <= 65535 [us]

> vorsteuer = { vorsteuerung = 'ADD_VEL', velocity_delay_time = 65535 }
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000 }]

> vorsteuer = { vorsteuerung = 'ADD_VEL', velocity_delay_time = 120000 }
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000 }]
set.toml:3:63: warning[AX416]: `vorsteuer.velocity_delay_time` (P-AXIS-00389) is 120000 us: error 70349 of the controller; the delay is corrected to 0
    allowed: 0 <= velocity_delay_time < 6 cycles, 20ms each [us]
",
    );
}

/// The summary lists what nobody gave, with its default.
#[test]
fn assumed_values() {
    let assumed = |given: &str| {
        let (set, report) = read_list(direct(given).replace("ipc.", IPC));
        let set = set.unwrap_or_else(|| panic!("{report}"));
        let text = generator::summary::text(&set.axes[0]);
        text.lines().find(|line| line.starts_with("  assumed: ")).unwrap_or_default().to_owned()
    };
    assert_eq!(
        assumed("getriebe[0].kv 2000"),
        "  assumed: vb_max 200000 (P-AXIS-00212), multi_gain_n 1 (P-AXIS-00128), multi_gain_z 2000 (P-AXIS-00129)"
    );
    assert_eq!(
        assumed(
            "getriebe[0].kv 2000\ngetriebe[0].multi_gain_z 1\ngetriebe[0].multi_gain_n 1\ngetriebe[0].dynamik.vb_max 500000"
        ),
        ""
    );
}

/// The manual's formulas take the gear ratio from P-AXIS-00234 and 00233: one that stands elsewhere would be lost.
#[test]
fn a_gear_ratio_in_other_parameters() {
    assert_transcript(
        said_of_axis,
        r#"
> kenngr.antr_typ = 3
> vorsteuer.vorsteuerung = 'ADD_VEL'
> vorsteuer.shift_time = 3
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000, incr_per_rev = 1024, gear_fact_num = 3 }]
set.toml:7:63: error[AX319]: the gear ratio 3/1 (P-AXIS-00511, 00512) would not reach the angle of the motor
    allowed: the ratio in P-AXIS-00234 and 00233 alone
    write instead: getriebe[0].wegaufz 3 and getriebe[0].wegaufn 1, beside the feed constant

> kenngr.antr_typ = 3
> vorsteuer.vorsteuerung = 'ADD_VEL'
> vorsteuer.shift_time = 3
> process_data.additive_velocity = 'INT32'
> getriebe = [{ kv = 2000, incr_per_rev = 1024, gear_fact_num = 3, gear_fact_denom = 3 }]

> vorsteuer.vorsteuerung = 'VEL'
> getriebe = [{ kv = 2000, gear_fact_num = 3 }]
"#,
    );
}

#[test]
fn a_measuring_probe() {
    assert_transcript(
        said_of_axis,
        r#"
> vorsteuer.vorsteuerung = 'VEL'
> getriebe = [{ kv = 2000 }]
> kenngr.hub_messtaster = 20000
set.toml:5:25: warning[AX441]: the axis has a measuring probe (P-AXIS-00086), and feedforward delays its position by a cycle at the least
    write instead: a kenngr.hub_messtaster that is longer by the path of the delay

> vorsteuer.vorsteuerung = 'VEL'
> getriebe = [{ kv = 2000 }]
> kenngr.hub_messtaster = 0
"#,
    );
}
