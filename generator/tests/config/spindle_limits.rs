//! What the cycle time and the deceleration of a changeover allow, to the letter.

use super::{assert_transcript, in_cnc, said_of_axis, said_of_set, sercos};

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
    write instead: a shorter time, or a larger spindle.deceleration
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

#[test]
fn the_cnc_has_no_such_limit() {
    assert_transcript(
        |given| said_of_axis(&in_cnc(given)),
        r"
> antr.sai_op_mode_change.v_velocity_control_on = 300000000
> getriebe = [{ kv = 10000, dynamik.vb_max = 600000000 }]
",
    );
}
