//! What the cycle time and the deceleration of a changeover allow, to the letter.

use super::{read_set, said_of_set};
use generator::target::TARGETS;

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

/// What a message about a lag proposes, applied, has no message about a lag. Each velocity stands in a line of its own.
#[test]
fn what_is_written_instead_of_a_lag_has_none() {
    const ON: &str = "antr.sai_op_mode_change.v_velocity_control_on = ";
    const OFF: &str = "antr.sai_op_mode_change.v_position_control_on = ";
    const KV: &str = "getriebe[0].kv ";
    let said = |[on, off, kv]: [&str; 3], of_drive: &str| {
        said_of_set(&format!(
            "cycle_time = '1ms'\n[axis.S]\nkenngr.achs_typ = 'ACHSTYP_SPINDEL'\nantr.nbr_delay_cycles = 4\n{ON}{on}\n{OFF}{off}\n\
             getriebe = [{{ kv = {kv}, multi_gain_z = 10000000, multi_gain_n = 360, dynamik.vb_max = 36000000 }}]\n{of_drive}"
        ))
    };
    let in_drive = "kenngr.antr_typ = 'SERCOS'\nantr.sercos.op_mode_for_velocity_control = 1\nantr.feed_forward_v_weighting = 500\n";
    let in_cnc =
        "kenngr.antr_typ = 'CONVENTIONAL'\nvorsteuer = { vorsteuerung = 'VEL', vs_v_faktor = 4, vs_v_nenner = 5 }\n";
    let without = "kenngr.antr_typ = 'CONVENTIONAL'\n";
    let of_lag = ["AX331", "AX448", "AX449"];
    for (values, of_drive, code, proposals) in [
        (["1200000", "300000", "20"], in_drive, "AX331", 2),
        (["6000000", "5000000", "250"], in_drive, "AX331", 2),
        (["6000000", "849000", "250"], in_drive, "AX448", 2),
        (["300000", "300000", "20"], in_drive, "AX331", 2),
        (["6000000", "300000", "500"], in_cnc, "AX331", 2),
        (["1200000", "300000", "500"], in_cnc, "AX449", 2),
        (["1200000", "300000", "20"], without, "AX331", 1),
    ] {
        let text = said(values, of_drive);
        assert!(text.contains(&format!("[{code}]")), "{values:?}\n{text}");
        let (_, of_code) = text.split_once(&format!("[{code}]")).unwrap();
        let (_, instead) = of_code.split_once("write instead: ").unwrap();
        let instead: Vec<&str> = instead.lines().next().unwrap().split(", or ").collect();
        assert_eq!(instead.len(), proposals, "{text}");
        for one in instead {
            let paths = ["v_velocity_control_on ", "v_position_control_on ", KV];
            let at = paths.iter().position(|path| one.starts_with(path)).unwrap_or_else(|| panic!("{one}"));
            let mut changed = values;
            changed[at] = one[paths[at].len()..].split(' ').next().unwrap();
            let after = said(changed, of_drive);
            assert!(!of_lag.iter().any(|code| after.contains(code)) && !after.contains("AX320"), "{one}\n{after}");
        }
    }
}
