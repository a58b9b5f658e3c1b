//! Feedforward, position control, gantries: what is refused, corrected and warned of, to the letter.

use super::{IPC, direct, read_list};

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

/// The increments of a linear motor, and of a motor with a feed constant, have no effect.
#[test]
fn assumed_path_resolutions() {
    let assumed = |keys: &str| {
        let (set, report) = super::read_set(format!(
            "cycle_time = '1ms'\n[axis.X]\nkenngr.antr_typ = 'SERCOS'\nprocess_data.additive_torque = 'INT32'\n\
             vorsteuer.vorsteuerung = 'ADD_ACC'\ngetriebe = [{{ load = 1e-5 }}]\n{keys}"
        ));
        set.unwrap_or_else(|| panic!("{report}")).axes[0].axis.control.assumed.join(", ")
    };
    let ratio = "wegaufn 1 (P-AXIS-00233), wegaufz 1 (P-AXIS-00234)";
    assert_eq!(assumed("motor = 'linear'"), "");
    assert_eq!(assumed("antr.feed_const_num = 100000"), ratio);
    assert_eq!(assumed(""), format!("incr_per_rev 1024 (P-AXIS-00092), {ratio}"));
}

/// The object that holds the gain, by the bus of the drive.
#[test]
fn where_the_gain_of_a_drive_is() {
    let line = |drive: &str| {
        let keys = format!("kenngr.antr_typ = '{drive}'\ngetriebe = [{{ kv = 2000 }}]\n");
        let (set, report) = super::read_set(format!("cycle_time = '1ms'\n[axis.X]\n{keys}"));
        let lines = generator::summary::details(&set.unwrap_or_else(|| panic!("{report}")).axes[0]).lines;
        lines.into_iter().find(|line| line.starts_with("Kv ")).unwrap_or_default()
    };
    let said = "Kv 20/s (P-AXIS-00099): that of the drive must be equal";
    assert_eq!(line("SERCOS"), format!("{said} (SERCOS S-0-0104: 1.2 in 1000/min)"));
    assert_eq!(line("CANOPEN"), format!("{said} (CANopen 30C0h:01)"));
    assert_eq!(line("PROFIDRIVE"), said);
}
