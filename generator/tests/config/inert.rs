//! Settings that leave a function without effect, and those that cut its output off.

use super::{assert_transcript, indirect, read_set, said, said_of_axis};
use generator::axis::{Control, Quantities};

#[test]
fn enabled_and_no_stage_is_active() {
    assert_transcript(
        said,
        r"
> ipc.enable ON
> getriebe[0].kv 2000
x.lis:1:43: warning[AX401]: improved position control is ON, and no stage is active: it adds nothing
    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT

> getriebe[0].kv 2000
> ipc.enable DRYRUN
x.lis:2:43: warning[AX401]: improved position control is DRYRUN, and no stage is active: it adds nothing
    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT

> ipc.enable OFF
> getriebe[0].kv 2000
",
    );
}

#[test]
fn factors_of_0() {
    assert_transcript(
        said_of_axis,
        r#"
> kenngr.antr_typ = 'SERCOS'
> antr.v_reso_num = 0
> process_data.additive_velocity = 'INT32'
> ipc.enable = 'ON'
> ipc.v_add_max_fact = 1
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
> getriebe = [{ dynamik.vb_max = 200000 }]
set.toml:4:19: warning[AX433]: `antr.v_reso_num` (P-AXIS-00206) is 0: the additive velocity is always 0
    write instead: a value above 0, or process_data.additive_velocity = "NONE"

> vorsteuer.vorsteuerung = 'VEL'
> vorsteuer.vs_v_faktor = 0
> getriebe = [{ kv = 2000 }]
set.toml:4:25: warning[AX433]: `vorsteuer.vs_v_faktor` (P-AXIS-00228) is 0: the whole feedforward is always 0
    write instead: a value above 0, or NONE in vorsteuer.vorsteuerung

> vorsteuer.vorsteuerung = 'VEL ACC'
> vorsteuer.vs_a_faktor = 0
> getriebe = [{ kv = 2000 }]
set.toml:4:25: warning[AX433]: `vorsteuer.vs_a_faktor` (P-AXIS-00225) is 0: the acceleration is always 0, and so is a jerk that has its time constant
    write instead: a value above 0, or no ACC in vorsteuer.vorsteuerung

> vorsteuer.vorsteuerung = 'ACC JERK'
> vorsteuer.vs_a_faktor = 4000
> vorsteuer.jerk_fact_num = 0
> getriebe = [{ kv = 2000 }]
set.toml:5:27: warning[AX433]: `vorsteuer.jerk_fact_num` (P-AXIS-00337) is 0: the feedforward of the jerk is always 0
    write instead: a value above 0, or no JERK in vorsteuer.vorsteuerung

> vorsteuer.vorsteuerung = 'ADD_ACC'
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0 }]
set.toml:5:33: warning[AX433]: `getriebe[0].load` (P-AXIS-00391) is 0: the additive torque is always 0
    write instead: a value above 0, or no ADD_ACC in vorsteuer.vorsteuerung
"#,
    );
}

/// 12/10 is a weight of ADD_ACC, and as a time constant 1.2 us.
#[test]
fn a_time_constant_that_no_drive_has() {
    assert_transcript(
        said_of_axis,
        r"
> vorsteuer = { vorsteuerung = 'VEL ACC', vs_a_faktor = 12, vs_a_nenner = 10 }
> getriebe = [{ kv = 2000 }]
set.toml:3:55: warning[AX434]: the time constant of the acceleration is 12/10 = 1.2 us (P-AXIS-00225/00226), 0.0012 of a cycle: next to nothing
    write instead: the drive's time constant in us; a plain weight such as 12/10 is for ADD_ACC

> vorsteuer = { vorsteuerung = 'VEL ACC', vs_a_faktor = 50 }
> getriebe = [{ kv = 2000 }]

> vorsteuer = { vorsteuerung = 'ADD_ACC', vs_a_faktor = 12, vs_a_nenner = 10 }
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
",
    );
}

#[test]
fn a_default_of_add_jerk_is_a_time() {
    assert_transcript(
        said_of_axis,
        r#"
> vorsteuer.vorsteuerung = 'ADD_JERK'
> add_jerk = 'experimental'
> process_data.additive_torque = 'INT16'
> getriebe = [{ kv = 2000, load = 0.1 }]
set.toml:3:26: warning[AX422]: the factor of the jerk (P-AXIS-00337/00338) has its default, 1/100, which ADD_JERK takes for 0.01 s
    write instead: vorsteuer.jerk_fact_num and jerk_fact_denom: with ADD_JERK the lag of the torque loop in s
"#,
    );
}

#[test]
fn process_data_that_saturate() {
    assert_transcript(
        said_of_axis,
        r#"
> process_data.velocity_command = 'INT16'
> getriebe = [{ kv = 2000, multi_gain_z = 200000, dynamik.vb_max = 500000 }]
set.toml:3:33: warning[AX435]: the velocity command at vb_max, 500000 um/s, is 6000000 increments, and INT16 ends at 32767: it saturates at 2730.58 um/s
    write instead: INT32, if the drive has it, or a scaling with fewer increments

> process_data.velocity_command = 'INT16'
> getriebe = [{ kv = 2000, dynamik.vb_max = 273058 }]

> kenngr.achs_typ = 'ACHSTYP_SPINDEL'
> getriebe = [{ kv = 2000, multi_gain_z = 4000000000, dynamik.vb_max = 36000000 }]
set.toml:4:41: warning[AX435]: the velocity command at vb_max, 36000000 0.001 deg/s, is 8640000000000 increments, and INT32 ends at 2147483647: it saturates at 8947.85 0.001 deg/s
    write instead: a scaling with fewer increments

> kenngr.antr_typ = 'SERCOS'
> process_data.additive_velocity = 'INT16'
> ipc.enable = 'ON'
> ipc.v_add_max_fact = 500
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
> getriebe = [{ dynamik.vb_max = 200000 }]
set.toml:4:34: warning[AX435]: the additive velocity at its limit v_add_max_fact, 100000 um/s, is 166667 increments, and INT16 ends at 32767: it saturates at 19660.2 um/s
    write instead: INT32, if the drive has it, or a scaling with fewer increments

> vorsteuer.vorsteuerung = 'ADD_VEL'
> process_data.additive_velocity = 'INT16'
> antr.v_time_base = 1
> getriebe = [{ kv = 2000, dynamik.vb_max = 1200000 }]
set.toml:4:34: warning[AX435]: the additive velocity at vb_max, 1200000 um/s, is 33333.3 increments, and INT16 ends at 32767: it saturates at 1179610 um/s
    write instead: INT32, if the drive has it, or a scaling with fewer increments
"#,
    );
}

#[test]
fn a_simulated_oscillation_with_little_damping() {
    assert_transcript(
        |given| said(&indirect(given)),
        r"
> ipc.stage[0].osc_damping 0.001
> ipc.stage[0].weight_fact_num 7
> ipc.stage[0].weight_fact_denom 1
x.lis:1:57: warning[AX436]: stage[0] is INDIRECT with the damping ratio 0.001: its simulated oscillation has 500.001 times the motor's velocity at f0, with the weight 7 3500.01 times
    write instead: a larger damping ratio or a smaller weight, and DRYRUN first
x.lis:2:61: warning[AX461]: stage[0] with the weight 7 makes a drive that does exactly what was commanded one cycle before oscillate, from the weight 0.0191 on
    write instead: a weight of at most 0.00261, up to which the loop stays calm (Ms <= 2)

> ipc.stage[0].filter.damping 0.03
x.lis:1:60: warning[AX436]: stage[0] is INDIRECT with the damping ratio 0.03: its simulated oscillation has 16.6966 times the motor's velocity at f0, with the weight 1 16.6966 times
    write instead: a larger damping ratio or a smaller weight, and DRYRUN first
x.lis:3:1: warning[AX461]: stage[0] with the weight 1 makes a drive that does exactly what was commanded one cycle before oscillate, from the weight 0.207 on
    write instead: a weight of at most 0.0697, up to which the loop stays calm (Ms <= 2)

> ipc.stage[0].osc_damping 0.4
> ipc.stage[0].weight_fact_num 7
> ipc.stage[0].weight_fact_denom 1
",
    );
}

#[test]
fn parameters_without_effect() {
    assert_transcript(
        said_of_axis,
        r#"
> vorsteuer = { vs_a_faktor = 4000, velocity_delay_time = 100 }
> getriebe = [{ kv = 2000 }]
> ipc.v_add_max_fact = 1
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:3:29: warning[AX426]: nothing of what this axis does uses P-AXIS-00225, P-AXIS-00389
    write instead: vorsteuer.vorsteuerung (P-AXIS-00223) with VEL, ACC or others, if feedforward is meant

> antr.v_reso_num = 7
> process_data = { additive_velocity = 'INT32', additive_torque = 'NONE' }
> getriebe = [{ kv = 2000 }]
set.toml:3:19: warning[AX426]: nothing of what this axis does uses P-AXIS-00206, process_data.additive_velocity

> antr.v_reso_num = 7
> process_data.additive_torque = 'INT16'
> ipc.v_add_max_fact = 1
> ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]
set.toml:4:32: warning[AX426]: nothing of what this axis does uses process_data.additive_torque
"#,
    );
}

/// What is left out is not computed, and its input not judged: a bad acceleration must not take the velocity along.
#[test]
fn what_is_left_out_is_no_part_of_the_axis() {
    let control = |lines: &str| -> Control {
        let (set, _) = read_set(format!("cycle_time = \"1ms\"\n[axis.X]\ngetriebe = [{{ kv = 2000 }}]\n{lines}"));
        set.expect("a warning is no error").axes.remove(0).axis.control
    };
    let sums = |lines: &str| {
        let feedforward = control(lines).feedforward.expect("it has feedforward");
        [feedforward.conventional, feedforward.additive, feedforward.torque]
    };
    let none = Quantities::default();
    let all = "vorsteuer.vorsteuerung = 'VEL ACC JERK'\n";
    assert_eq!(sums(all), [Quantities { velocity: true, acceleration: true, jerk: true }, none, none]);
    let velocity = [Quantities { velocity: true, ..none }, none, none];
    for weight in ["vs_a_nenner", "vs_a_faktor"] {
        assert_eq!(sums(&format!("{all}vorsteuer.{weight} = 0")), velocity, "{weight}");
    }
    for weight in ["vs_v_nenner", "vs_v_faktor"] {
        assert_eq!(sums(&format!("{all}vorsteuer.{weight} = 0")), [none; 3], "{weight}");
    }
    let torque = "process_data.additive_torque = 'INT16'\nadd_jerk = 'experimental'\n\
                  vorsteuer.vorsteuerung = 'VEL ADD_ACC ADD_JERK'\nvorsteuer.vs_a_nenner = 0\n";
    assert_eq!(sums(torque), [velocity[0], none, Quantities { jerk: true, ..none }]);
}

/// P-AXIS-00165 delays the position for a feedforward that leads; one that is switched off leads nothing.
#[test]
fn a_position_waits_for_no_feedforward_that_is_off() {
    let shift = |datum: &str| {
        let lines = format!(
            "cycle_time = \"1ms\"\n[axis.P]\nkenngr.antr_typ = 'PROFIDRIVE'\nprocess_data.additive_velocity = '{datum}'\n\
             vorsteuer.vorsteuerung = 'ADD_VEL'\ngetriebe = [{{ kv = 2000, incr_per_rev = 1000 }}]\n"
        );
        let (set, _) = read_set(lines);
        let control = set.expect("a warning is no error").axes.remove(0).axis.control;
        control.position_control.expect("the drive controls the position").shift_time
    };
    assert_eq!([shift("INT32"), shift("NONE")], [3, 0]);
}
