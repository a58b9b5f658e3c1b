//! What the cycle time and the deceleration of a changeover allow, to the letter.

use super::{assert_transcript, in_cnc, read_set, said_of_axis, said_of_set, sercos};
use generator::target::TARGETS;

#[test]
fn times() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r#"
> spindle.brake_timeout = '2.95s'

> spindle.brake_timeout = '2.949999999s'
set.toml:3:25: error[AX326]: `spindle.brake_timeout` is 2.949999999s, and the ramp from vb_max 18000000 (P-AXIS-00212) to 300000 (P-AXIS-00768) takes 2.95s
    allowed: 2.95s <= brake_timeout, or 0s: twice the ramp and 0.5 s
    write instead: spindle.brake_timeout = "6.4s"

> spindle = { brake_timeout = '2s', deceleration = 9000000 }

> spindle.mode_timeout = '1ns'

> spindle.mode_timeout = '1000s'
> spindle.brake_timeout = '1000s'

> spindle.deceleration = 1
set.toml:3:24: error[AX327]: `spindle.brake_timeout` has its default, 35400000.5s, 35400000500 cycles
    allowed: 16777216 cycles: 16777.216s at a cycle time of 1ms
    write instead: a shorter time, or a larger spindle.deceleration: 6000 is 1 rpm/s
"#,
    );
}

#[test]
fn the_answer_takes_its_cycles() {
    assert_transcript(
        |given| said_of_axis(&sercos(given)),
        r#"
> spindle.mode_timeout = '4ms'

> spindle.mode_timeout = '3.999ms'
set.toml:3:24: error[AX326]: `spindle.mode_timeout` is 3.999ms, and the drive's answer takes 4ms (P-AXIS-00191)
    allowed: 4ms <= mode_timeout
    write instead: spindle.mode_timeout = "0.1s"

> spindle.mode_timeout = '0.1s'
> spindle.brake_timeout = '1ms'
set.toml:4:25: error[AX326]: `spindle.brake_timeout` is 1ms, and the ramp from vb_max 18000000 (P-AXIS-00212) to 300000 (P-AXIS-00768) takes 2.95s
    allowed: 2.95s <= brake_timeout, or 0s: twice the ramp and 0.5 s
    write instead: spindle.brake_timeout = "6.4s"
"#,
    );
}

/// At 2 ms 15000 rpm, strictly: the velocity up to which position control lasts, and that at which it is taken up again.
#[test]
fn half_a_revolution_in_a_cycle() {
    assert_transcript(
        |given| said_of_set(&format!("cycle_time = \"2ms\"\n[axis.X]\n{}", sercos(given))),
        r"
> # 15000 rpm are too many, 14999.99 are not
> getriebe = [{ kv = 2000, dynamik.vb_max = 90000000 }]
> antr.sai_op_mode_change.v_velocity_control_on = 90000000
set.toml:5:49: error[AX323]: in position control the spindle turns with up to 15000 rpm: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 90000000, `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 90000000
    allowed: less than half a revolution in a cycle: below 15000 rpm, 90000000 [0.001 deg/s], at a cycle time of 2ms
    write instead: a lower v_velocity_control_on: 200 rpm are 1200000

> getriebe = [{ kv = 2000, dynamik.vb_max = 89999999 }]
> antr.sai_op_mode_change.v_velocity_control_on = 2000000000
set.toml:4:49: warning[AX444]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 2000000000, and vb_max 89999999 (P-AXIS-00212) is not above it: the spindle stays in position control
    write instead: v_velocity_control_on with a speed of the spindle: 200 rpm are 1200000

> getriebe = [{ kv = 2000, dynamik.vb_max = 2000000000 }]
> antr.sai_op_mode_change.v_velocity_control_on = 89999999
set.toml:2:7: warning[AX435]: the velocity command at vb_max, 2000000000 0.001 deg/s, is 3333330000 increments, and INT32 ends at 2147483647: it saturates at 1288490000 0.001 deg/s
    write instead: a scaling with fewer increments

> getriebe = [{ kv = 2000, dynamik.vb_max = 2000000000 }]
> antr.sai_op_mode_change.v_velocity_control_on = 90000000
set.toml:4:49: error[AX323]: in position control the spindle turns with up to 15000 rpm: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 90000000, `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 2000000000
    allowed: less than half a revolution in a cycle: below 15000 rpm, 90000000 [0.001 deg/s], at a cycle time of 2ms
    write instead: a lower v_velocity_control_on: 200 rpm are 1200000

> getriebe = [{ kv = 2000, dynamik.vb_max = 90000000 }]
> antr.sai_op_mode_change.v_velocity_control_on = 2000000000
> antr.sai_op_mode_change.v_position_control_on = 89108911
set.toml:5:49: error[AX323]: `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) is 89108911: with its window of 148.515 rpm the drive takes up position control at up to 15000 rpm
    allowed: less than half a revolution in a cycle: below 15000 rpm, 90000000 [0.001 deg/s], at a cycle time of 2ms
    write instead: a lower v_position_control_on or spindle.window: 50 rpm are 300000
set.toml:3:43: error[AX323]: in position control the spindle turns with up to 15000 rpm: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 90000000, `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 2000000000
    allowed: less than half a revolution in a cycle: below 15000 rpm, 90000000 [0.001 deg/s], at a cycle time of 2ms
    write instead: a lower v_velocity_control_on: 200 rpm are 1200000

> getriebe = [{ kv = 2000, dynamik.vb_max = 89000000 }]
> antr.sai_op_mode_change.v_velocity_control_on = 89108911
> antr.sai_op_mode_change.v_position_control_on = 89108911
> spindle.window = 1
set.toml:5:49: error[AX323]: `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) is 89108911: with its window of 148.515 rpm the drive takes up position control at up to 15000 rpm
    allowed: less than half a revolution in a cycle: below 15000 rpm, 90000000 [0.001 deg/s], at a cycle time of 2ms
    write instead: a lower v_position_control_on or spindle.window: 50 rpm are 300000

> getriebe = [{ kv = 2000, dynamik.vb_max = 89000000 }]
> antr.sai_op_mode_change.v_velocity_control_on = 89108910
> antr.sai_op_mode_change.v_position_control_on = 89108910
> spindle.window = 1
set.toml:4:49: warning[AX444]: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 89108910, and vb_max 89000000 (P-AXIS-00212) is not above it: the spindle stays in position control
    write instead: v_velocity_control_on with a speed of the spindle: 200 rpm are 1200000

> getriebe = [{ kv = 2000, dynamik.vb_max = 89000000 }]
> spindle.window = 89700000
set.toml:8:49: error[AX323]: `antr.sai_op_mode_change.v_position_control_on` (P-AXIS-00768) is 300000: with its window of 14950 rpm the drive takes up position control at up to 15000 rpm
    allowed: less than half a revolution in a cycle: below 15000 rpm, 90000000 [0.001 deg/s], at a cycle time of 2ms
    write instead: a lower v_position_control_on or spindle.window: 50 rpm are 300000

> getriebe = [{ kv = 2000, dynamik.vb_max = 89000000 }]
> spindle.window = 89699999
",
    );
}

/// Not in a cycle; but 170 deg of lag.
#[test]
fn the_cnc_has_another_limit() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> antr.sai_op_mode_change.v_velocity_control_on = 300000000
> getriebe = [{ kv = 200000, dynamik.vb_max = 600000000 }]

> antr.sai_op_mode_change.v_velocity_control_on = 3600000
> getriebe = [{ kv = 1000, dynamik.vb_max = 18000000 }]
set.toml:3:49: error[AX331]: the position lag at 600 rpm is 360 deg: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 3600000, `getriebe[0].kv` (P-AXIS-00099) is 1000
    allowed: a lag below 170 deg: (1 - w) v / Kv
    write instead: v_velocity_control_on 1700000 or less, or getriebe[0].kv 2118 or more

> antr.sai_op_mode_change.v_velocity_control_on = 1699999
> getriebe = [{ kv = 1000, dynamik.vb_max = 18000000 }]

> antr.sai_op_mode_change.v_velocity_control_on = 3600000
> getriebe = [{ kv = 2118, dynamik.vb_max = 18000000 }]

> antr.sai_op_mode_change.v_velocity_control_on = 3600000
> getriebe = [{ kv = 1000, multi_gain_z = 1, multi_gain_n = 1, dynamik.vb_max = 18000000 }]
> vorsteuer.vorsteuerung = 'VEL'
set.toml:3:49: warning[AX449]: the position lag at 600 rpm is 360 deg, without feedforward: `antr.sai_op_mode_change.v_velocity_control_on` (P-AXIS-00767) is 3600000, `getriebe[0].kv` (P-AXIS-00099) is 1000
    allowed: a lag below 170 deg: (1 - w) v / Kv
    write instead: v_velocity_control_on 1700000 or less, or getriebe[0].kv 2118 or more

> antr.sai_op_mode_change.v_velocity_control_on = 3600000
> getriebe = [{ kv = 1000, multi_gain_z = 1, multi_gain_n = 1, dynamik.vb_max = 18000000 }]
> vorsteuer = { vorsteuerung = 'VEL', default_active = true }
",
    );
}

/// 1024 increments a turn are steps of 58.6 rpm in a cycle of 1 ms.
#[test]
fn a_window_narrower_than_the_steps_of_the_encoder() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> getriebe = [{ kv = 10000, wegaufz = 1024, wegaufn = 3600000, dynamik.vb_max = 18000000 }]

> getriebe = [{ kv = 10000, wegaufz = 1024, wegaufn = 3600000, dynamik.vb_max = 18000000 }]
> spindle.window = 6000
set.toml:4:18: warning[AX450]: `spindle.window` is 6000, 1 rpm: two steps of the encoder are 117.188 rpm
    write instead: spindle.window = 703125, or without it

> getriebe = [{ kv = 10000, wegaufz = 1024, wegaufn = 3600000, dynamik.vb_max = 18000000 }]
> spindle.window = 703125
",
    );
}

/// Every spindle whose drive controls the position, and no other axis.
#[test]
fn half_a_revolution_without_a_changeover() {
    assert_transcript(
        said_of_axis,
        r"
> kenngr = { achs_typ = 'ACHSTYP_SPINDEL', antr_typ = 'SERCOS' }
> getriebe = [{ kv = 2000, dynamik.vb_max = 180000000 }]
> vorsteuer.vorsteuerung = 'VEL'
set.toml:4:43: error[AX323]: in position control the spindle turns with up to 30000 rpm: `getriebe[0].dynamik.vb_max` (P-AXIS-00212) is 180000000
    allowed: less than half a revolution in a cycle: below 30000 rpm, 180000000 [0.001 deg/s], at a cycle time of 1ms
    write instead: a lower vb_max, a shorter cycle, or v_velocity_control_on: 200 rpm are 1200000

> kenngr = { achs_typ = 'ACHSTYP_SPINDEL', antr_typ = 'SERCOS' }
> getriebe = [{ kv = 2000, dynamik.vb_max = 179999999 }]
> vorsteuer.vorsteuerung = 'VEL'
",
    );
}

/// Operation modes of a spindle's or of another bus's drive.
#[test]
fn modes_that_an_axis_does_not_have() {
    assert_transcript(
        said_of_axis,
        r"
> kenngr = { achs_typ = 'ACHSTYP_ROTATOR', antr_typ = 'SERCOS' }
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
> antr = { sercos.op_mode_for_velocity_control = 1, canopen.cyclic_position_op_mode = 8, canopen.cyclic_velocity_op_mode = 9 }
set.toml:5:85: warning[AX426]: without effect here: an axis that is ACHSTYP_ROTATOR (P-AXIS-00018) with a drive that is SERCOS (P-AXIS-00020) does not have P-AXIS-00463, P-AXIS-00464, P-AXIS-00264

> kenngr = { achs_typ = 'ACHSTYP_ROTATOR', antr_typ = 'CANOPEN' }
> getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]
> antr = { canopen.cyclic_position_op_mode = 8, canopen.cyclic_velocity_op_mode = 9 }
",
    );
}

/// Von = Voff = 0: no position mode, no position, no delay, no Kv is asked for.
#[test]
fn a_drive_with_velocity_control_alone() {
    assert_transcript(
        said_of_axis,
        r"
> kenngr = { achs_typ = 'ACHSTYP_SPINDEL', antr_typ = 'SERCOS' }
> getriebe = [{ dynamik.vb_max = 18000000 }]
> antr.sai_op_mode_change = { v_velocity_control_on = 0, v_position_control_on = 0 }
> process_data.objects = ['S-0-0036', 'S-0-0040']
> drive_settings = ['S-0-0044=010']
",
    );
}

/// Its blocks are generated, for either bus in either precision. They do not depend on a Kv, and have no id of a change of mode.
#[test]
fn blocks_of_a_drive_with_velocity_control_alone() {
    for (bus, real) in [("SERCOS", "f64"), ("SERCOS", "f32"), ("CANOPEN", "f64"), ("CANOPEN", "f32")] {
        let blocks = |kv: &str| {
            let (set, report) = read_set(format!(
                "cycle_time = '1ms'\n[axis.S]\nreal = '{real}'\n\
                 kenngr = {{ achs_typ = 'ACHSTYP_SPINDEL', antr_typ = '{bus}' }}\n\
                 getriebe = [{{ dynamik.vb_max = 18000000{kv} }}]\n\
                 antr.sai_op_mode_change = {{ v_velocity_control_on = 0, v_position_control_on = 0 }}\n"
            ));
            let set = set.unwrap_or_else(|| panic!("{report}"));
            let files = generator::generate::files(&set, &[], &TARGETS, |made| made.file);
            let files = files.unwrap_or_else(|defect| panic!("{bus} {real}: {defect}"));
            files
                .into_iter()
                .map(|file| (file.name, file.text))
                .filter(|(name, _)| name.starts_with("axis_s_spindle."))
                .collect()
        };
        let files: Vec<(String, String)> = blocks("");
        assert_eq!(files, blocks(", kv = 2000"));
        let (_, header) = files.iter().find(|(name, _)| name.ends_with(".h")).unwrap_or_else(|| panic!("a header"));
        let has = |id: &str| header.contains(&format!("AXIS_S_SPINDLE_ERROR_{id}"));
        assert_eq!(["TO_VELOCITY", "BRAKE", "MODE_DISPLAY", "ONLY_VELOCITY"].map(has), [false, true, false, true]);
    }
}
