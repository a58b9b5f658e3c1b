//! What `check` says that a changeover will do, and what of it reaches the blocks.

use super::{canopen, in_cnc, read_list, read_set, sercos};
use generator::axis::{Bus, Changeover, Ratio, Spindle, TimeBase, Velocity, Width};
use generator::blocks::Designed;
use generator::summary;

fn designed(lines: &str) -> Designed {
    let (set, report) = read_set(format!("cycle_time = \"2ms\"\n[axis.S]\n{lines}"));
    set.unwrap_or_else(|| panic!("{lines}\n{report}")).axes.remove(0)
}

fn spindle(lines: &str) -> Spindle {
    designed(lines).axis.control.spindle.expect("it changes over")
}

/// The lines of a summary that are about the changeover.
fn words(lines: &str) -> Vec<String> {
    let text = summary::text(&designed(lines));
    let lines = text.lines().map(str::trim_start).skip_while(|line| !line.starts_with("changeover"));
    lines.take_while(|line| !line.starts_with("assumed")).map(str::to_owned).collect()
}

/// The manual's first example: 200 and 50 rpm, Kv 20/s, 50 % feedforward, 1e-4 rpm at the velocity interface. 60 deg
/// of lag are 30 with the feedforward.
#[test]
fn the_example_of_a_sercos_drive() {
    let example = sercos(
        "antr.sai_op_mode_change.feed_forward_v_weighting = 500\nantr.v_time_base = 0\nantr.v_reso_num = 1\nantr.v_reso_denom = 36",
    );
    assert_eq!(
        words(&example),
        [
            "changeover: M3 and M4 above 200 rpm (1200 deg/s) lead to velocity control, back at 50 rpm (300 deg/s) within 1 rpm",
            "the drive changes from mode 0, position control, to mode 1, velocity control, and back, within 100ms each (SERCOS: 0 is \
             S-0-0032, 1 to 3 are S-0-0033 to S-0-0035)",
            "it brakes by 1000 rpm/s: from vb_max, 3000 rpm (18000 deg/s), in 2.95s, or it stops with an error after 6.4s",
            "the position lag at 200 rpm must be 30 deg: Kv 20/s (S-0-0104), 50 % feedforward (S-0-0296), 4 delay cycles",
            "the drive must have in its cyclic telegram (process_data.objects): S-0-0036 the velocity command, S-0-0040 the actual \
             velocity, S-0-0047 the position command, S-0-0051 or S-0-0053 the actual position",
            "and these settings (drive_settings; 010: bits 2 to 0): S-0-0032=3 position control in the main mode, S-0-0033=2 velocity \
             control in the auxiliary mode 1, S-0-0076=010 rotary scaling of positions, S-0-0044=010 rotary scaling of velocities, \
             S-0-0160=010 rotary scaling of accelerations",
        ]
    );
    let reso = Ratio { num: 1, denom: 36 };
    let drive = Changeover::Drive {
        bus: Bus::Sercos,
        position_mode: 0,
        velocity_mode: 1,
        feed_forward_v_weighting: 500,
        velocity: Velocity { reso, time_base: TimeBase::Minute, width: Width::Int32 },
    };
    let expected = Spindle {
        v_velocity_control_on: 1_200_000,
        v_position_control_on: 300_000,
        drive,
        feedforward: None,
        default_active: false,
        kv: 2000,
        delay_cycles: 4,
        deceleration: 6e6,
        window: 6000.0,
        takeover_window: 1000.0,
        mode_timeout_ns: 100_000_000,
        brake_timeout_ns: 6_400_000_000,
    };
    assert_eq!(spindle(&example), expected);
}

/// Its second one, with the values at their names: Kv 4000/min is 66.66/s. The third one is in the CNC: 100/s.
#[test]
fn the_lag_of_the_other_examples() {
    let lag = |lines: &str| words(lines).remove(3);
    assert_eq!(
        lag(&sercos("getriebe = [{ kv = 6666, dynamik.vb_max = 18000000 }]")),
        "the position lag at 200 rpm must be 18.0018 deg: Kv 66.66/s (S-0-0104), 0 % feedforward (S-0-0296), 4 delay cycles"
    );
    assert_eq!(
        lag(&sercos("# no feedforward")),
        "the position lag at 200 rpm must be 60 deg: Kv 20/s (S-0-0104), 0 % feedforward (S-0-0296), 4 delay cycles"
    );
    assert_eq!(
        lag(&in_cnc("vorsteuer.vorsteuerung = 'VEL'"))[..],
        *"without feedforward the position lag at 200 rpm must be 12 deg, within 1 %: else P-AXIS-00129/00128 do not scale the \
          velocity command as the drive does (Kv 100/s)"
    );
}

#[test]
fn a_canopen_drive() {
    let lines = words(&canopen(
        "antr.canopen.cyclic_velocity_op_mode = -3\nantr.feed_forward_v_weighting = 1200\nspindle.mode_timeout = '0.25s'",
    ));
    assert_eq!(
        lines[1],
        "the drive changes from mode 8, position control, to mode -3, velocity control, and back, within 250ms each (CANopen: 6060h \
         and 6061h)"
    );
    assert_eq!(
        lines[3..],
        [
            "the position lag at 200 rpm must be -12 deg: Kv 20/s (30C0h:01), 120 % feedforward (3062h), 4 delay cycles",
            "the drive must have in its cyclic telegram (process_data.objects): 6060h the operation mode, 6061h the display of the \
             operation mode, 607Ah the position command, 6064h the actual position, 60FFh the velocity command, 606Ch the actual velocity",
        ]
    );
}

#[test]
fn a_spindle_without_a_sensor() {
    let lines = words(&in_cnc(
        "antr.sai_op_mode_change.v_velocity_control_on = 0\nantr.sai_op_mode_change.v_position_control_on = 0",
    ));
    assert_eq!(
        lines,
        [
            "changeover: M3 and M4 above 0 rpm (0 deg/s) lead to velocity control, back at 0 rpm (0 deg/s) within 1 rpm",
            "the CNC opens and closes its position loop, within a cycle; the drive stays in velocity control",
            "it brakes by 1000 rpm/s: from vb_max, 3000 rpm (18000 deg/s), in 3s, or it stops with an error after 6.5s",
            "velocity control at every speed, as a spindle without a position sensor needs it; M19, S[PUTAX], G74 and reset lead to \
             position control",
        ]
    );
}

/// The window grows with the velocity of position control.
#[test]
fn one_per_cent() {
    let fast = in_cnc("antr.sai_op_mode_change.v_position_control_on = 900000");
    assert!(words(&fast)[0].ends_with("back at 150 rpm (900 deg/s) within 1.5 rpm"));
    let wide = in_cnc("spindle.window = 60000");
    assert!(words(&wide)[0].ends_with("back at 50 rpm (300 deg/s) within 10 rpm"));
}

/// With position control in the CNC the lag is what feedforward leaves of it.
#[test]
fn feedforward_of_the_cnc() {
    let counted = |lines: &str| {
        let of = spindle(&in_cnc(&format!("vorsteuer = {{ vs_v_faktor = 8, vs_v_nenner = 10, {lines} }}")));
        (of.feedforward, of.default_active)
    };
    let weight = Some(Ratio { num: 8, denom: 10 });
    assert_eq!(counted("vorsteuerung = 'VEL'"), (weight, false));
    assert_eq!(counted("vorsteuerung = 'VEL', default_active = true"), (weight, true));
    for none in ["vorsteuerung = 'ACC'", "vorsteuerung = 'NONE'", "vorsteuerung = 'VEL', global_disable = true"] {
        assert_eq!(counted(none), (None, false));
    }
}

/// The old names are the new ones.
#[test]
fn predecessors_are_the_same_axis() {
    let old = "antr.velocity_position_control_on = 1200000\nantr.velocity_position_control_off = 300000\n";
    let rest = in_cnc("# none").replace("antr.sai_op_mode_change.v_", "#");
    let [old, new] = [format!("{old}{rest}"), in_cnc("# none")].map(|lines| designed(&lines).axis);
    assert_eq!(old, new);
    let weights = ["antr.sai_op_mode_change.feed_forward_v_weighting = 7", "antr.feed_forward_v_weighting = 7"];
    let [old, new] = weights.map(|weight| designed(&sercos(weight)).axis);
    assert_eq!(old, new);
}

/// The digest of a block covers what it is made of: the changeover is made of its own parameters, which no other
/// block is made of.
#[test]
fn what_the_digests_cover() {
    let lines = "antr.feed_forward_v_weighting = 300\nspindle.window = 7000\ngetriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]";
    let before = designed(&sercos(lines)).axis;
    for (path, value, other) in [
        ("v_velocity_control_on", "1200000", "1200001"),
        ("v_position_control_on", "300000", "300001"),
        ("nbr_delay_cycles", "4", "3"),
        ("op_mode_for_velocity_control", "1", "2"),
        ("feed_forward_v_weighting", "300", "301"),
        ("window", "7000", "7001"),
    ] {
        let [from, to] = [value, other].map(|value| format!("{path} = {value}"));
        let after = designed(&sercos(lines).replace(&from, &to)).axis;
        assert_ne!(before.canonical_of("spindle"), after.canonical_of("spindle"), "{path}");
        for block in ["ipc", "feedforward", "position_control"] {
            assert_eq!(before.canonical_of(block), after.canonical_of(block), "{block}: {path}");
        }
    }
    assert!(before.canonical_of("spindle").contains("antr_typ SERCOS"));
    // What the drive must offer changes nothing in a block.
    let named = format!("process_data.objects = ['S-0-0036', 'S-0-0040', 'S-0-0047', 'S-0-0051']\n{}", sercos(lines));
    assert_eq!(designed(&named).axis, before);
}

/// Without a changeover nothing is different.
#[test]
fn an_axis_that_is_no_spindle_is_what_it_was() {
    let axis = |lines: &str| read_list(lines).0.expect("a warning is no error").axes.remove(0).axis;
    let list = "kenngr.achs_typ ACHSTYP_ROTATOR\nkenngr.antr_typ SERCOS\ngetriebe[0].kv 2000\n";
    let given = "antr.sai_op_mode_change.v_velocity_control_on 1200000\nantr.sercos.op_mode_for_velocity_control 0\n";
    let [before, after] = [axis(list), axis(&format!("{list}{given}"))];
    assert_eq!(before, after);
    assert_eq!(after.canonical_of("axis"), after.canonical);
    assert_eq!(after.control.spindle, None);
}

/// The gain that the controller and a drive that controls the position share, with the drive's own name for it: of a spindle
/// as of any axis.
#[test]
fn the_gain_of_the_drive() {
    let said = |lines: &str| {
        let text = summary::details(&designed(lines)).text();
        text.lines().filter_map(|line| line.trim_start().strip_prefix("Kv ")).map(str::to_owned).collect::<Vec<_>>()
    };
    let axis = |drive: &str| format!("getriebe = [{{ kv = 2050, dynamik.vb_max = 500000 }}]\n{drive}");
    let equal = |of_drive: &str| [format!("20.5/s (P-AXIS-00099): that of the drive must be equal ({of_drive})")];
    assert_eq!(said(&axis("kenngr.antr_typ = 'SERCOS'")), equal("SERCOS S-0-0104: 1.23 in 1000/min"));
    assert_eq!(said(&axis("kenngr.antr_typ = 'CANOPEN'")), equal("CANopen 30C0h:01"));
    let lightbus = axis("kenngr.antr_typ = 'LIGHTBUS'\nantr.operation_mode = 'DRIVE_POSITION_CONTROL'");
    assert_eq!(said(&lightbus), equal("SERCOS S-0-0104: 1.23 in 1000/min, CANopen 30C0h:01"));
    assert!(said(&axis("kenngr.antr_typ = 'SERCOS'\nantr.operation_mode = 'CNC_POSITION_CONTROL'")).is_empty());
    let of_spindle = |of_drive: &str| equal(of_drive).map(|line| line.replace("20.5", "20"));
    assert_eq!(said(&sercos("")), of_spindle("SERCOS S-0-0104: 1.2 in 1000/min"));
    assert_eq!(said(&canopen("")), of_spindle("CANopen 30C0h:01"));
    assert!(said(&in_cnc("")).is_empty());
    let alone = "antr.sai_op_mode_change.v_velocity_control_on = 0\nantr.sai_op_mode_change.v_position_control_on = 0";
    assert!(said(&sercos(alone)).is_empty() && said(&canopen(alone)).is_empty());
}
