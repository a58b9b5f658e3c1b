//! What the cycle time and the deceleration of a changeover allow, to the letter.

use super::read_set;
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
