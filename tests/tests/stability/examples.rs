//! Stages that are known to oscillate on an ideal drive, and one that does not.

use crate::random::{axis, read};

fn stage(mode: &str, weight: u32, filter: &str) -> String {
    format!("{{ {mode}, weight_fact_num = {weight}, weight_fact_denom = 10, filter = [{{ {filter} }}] }}")
}

/// The codes that are said of a stage, with the mode at start.
fn codes(enable: &str, stage: String) -> Vec<&'static str> {
    let (_, report) = read(&format!("cycle_time = \"1ms\"\n{}", axis("X", "", enable, &[stage])));
    let about = ["AX345", "AX461"];
    report.diagnostics.iter().map(|said| said.code).filter(|code| about.contains(code)).collect()
}

#[test]
fn stages_that_oscillate_on_an_ideal_drive_are_refused_where_they_start_on() {
    let wide = stage("mode = \"DIRECT\"", 30, "order = 3, prototype = \"BUTTERWORTH\", fg_f0 = 53.0, q_factor = 2.0");
    let heavy = stage("mode = \"DIRECT\"", 70, "order = 1, fg_f0 = 53.0, q_factor = 1.0");
    let undamped = stage("mode = \"INDIRECT\", osc_damping = 0.2", 19, "order = 1, fg_f0 = 11.0, q_factor = 2.0");
    for stage in [wide, heavy, undamped] {
        assert_eq!(codes("ON", stage.clone()), ["AX345"], "{stage}");
        assert_eq!(codes("DRYRUN", stage.clone()), ["AX461"], "{stage}");
        assert_eq!(codes("OFF", stage.clone()), ["AX461"], "{stage}");
    }
}

#[test]
fn the_stage_of_the_manual_is_calm() {
    let damped = stage("mode = \"INDIRECT\", osc_damping = 0.8", 19, "order = 1, fg_f0 = 11.0, q_factor = 2.0");
    assert!(codes("ON", damped).is_empty());
}
