//! The example `examples/twincat`: its program, its function block and the emitted blocks run together in the strict engine, cycle by
//! cycle, against the reference blocks and a schedule written by hand; planted mistakes are found.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::print_stdout, reason = "`--nocapture` shows how many mistakes were planted and found")]

mod checks;
mod project;
mod script;
mod world;

use checks::violations;
use project::{FB, GVL, MAIN, Project};
use rayon::prelude::*;
use script::{failing, script};

#[test]
fn the_glue_does_what_the_reference_and_the_schedule_say() {
    let project = Project::of_example();
    let rows = script(&project);
    let said = violations(&project, &project.program(|_, text| text), &rows);
    assert!(said.is_empty(), "{} rows:\n{}", rows.len(), said.join("\n"));
    let acting = rows.iter().filter(|row| row.state == 4).count();
    println!("{} cycles, {acting} of them with a block that acts, no difference", rows.len());
}

/// What the drive cannot take is held at the end of its range, and does not come back with the other sign.
#[test]
fn an_offset_beyond_32_bits_is_held() {
    let project = Project { increments: 1.0e6, ..Project::of_example() };
    let said = violations(&project, &project.program(|_, text| text), &script(&project));
    assert!(said.is_empty(), "{}", said.join("\n"));
}

/// A block of which one number is another fails its self-test: then it never acts, whatever the operator does.
#[test]
fn a_block_that_fails_its_self_test_never_acts() {
    for block in ["ipc", "feedforward"] {
        let project = Project { spoilt: Some(block), ..Project::of_example() };
        let rows = failing(&project);
        let said = violations(&project, &project.program(|_, text| text), &rows);
        assert!(said.is_empty(), "{block}:\n{}", said.join("\n"));
    }
}

/// The text with something else in the place of its only occurrence.
fn swap(text: &str, old: &str, new: &str) -> String {
    assert_eq!(text.matches(old).count(), 1, "{old:?} is there once");
    text.replace(old, new)
}

/// Mistakes as they are made at a machine: where, what stands there, what is written instead.
const PLANTED: &[(&str, &str, &str)] = &[
    (FB, "scaled := velocity_increments * ipc.v_add", "scaled := -velocity_increments * ipc.v_add"),
    (FB, "scaled := velocity_increments * ipc.v_add", "scaled := ipc.v_add"),
    (FB, "v_motor := um_per_mm * Axis.NcToPlc.ActVelo", "v_motor := Axis.NcToPlc.ActVelo"),
    (FB, "v_motor := um_per_mm * Axis.NcToPlc.ActVelo", "v_motor := -um_per_mm * Axis.NcToPlc.ActVelo"),
    (FB, "a_interpolator := um_per_mm * Axis.NcToPlc.SetAcc", "a_interpolator := Axis.NcToPlc.SetAcc"),
    (FB, "v_add_mm_s := ipc.v_add / um_per_mm", "v_add_mm_s := ipc.v_add"),
    (FB, "    velocity_offset := 0;\n", ""),
    (FB, "    torque_offset := 0;\n", ""),
    (FB, "acts := powered AND tests_passed AND NOT damping_tripped", "acts := powered AND NOT damping_tripped"),
    (FB, "acts := powered AND tests_passed AND NOT damping_tripped", "acts := powered AND tests_passed"),
    (FB, "acts := powered AND tests_passed AND NOT damping_tripped", "acts := tests_passed AND NOT damping_tripped"),
    (
        FB,
        "acts := powered AND tests_passed AND NOT damping_tripped",
        "acts := Enable AND tests_passed AND NOT damping_tripped",
    ),
    (FB, "    acts := FALSE;\n    damping_tripped", "    damping_tripped"),
    (FB, "power.Status AND Axis.Status.ControlLoopClosed AND drive_operates", "power.Status AND drive_operates"),
    (
        FB,
        "power.Status AND Axis.Status.ControlLoopClosed AND drive_operates",
        "power.Status AND Axis.Status.ControlLoopClosed",
    ),
    (FB, "may_have_power := Enable AND NOT axis_tripped", "may_have_power := Enable"),
    (FB, "resetting := axis_tripped AND NOT Enable", "resetting := axis_tripped"),
    (FB, "ELSIF Enable THEN", "ELSIF FALSE THEN"),
    (FB, "IF resetting AND reset_axis.Done AND NOT Axis.Status.Error", "IF resetting"),
    (FB, "acknowledged := acknowledge AND NOT acknowledge_before", "acknowledged := acknowledge"),
    (FB, "status_bits MOD 16 = 7", "status_bits MOD 8 = 7"),
    (FB, "status_bits / 32 MOD 4 = 1", "status_bits / 32 MOD 4 < 4"),
    (FB, "ELSIF Axis.Status.NotMoving THEN", "ELSIF acts THEN"),
    (FB, "    Enable := tests_passed,\n    v_motor", "    Enable := FALSE,\n    v_motor"),
    (FB, "    mode := mode,", "    mode := 1,"),
    (FB, "IF part >= half THEN", "IF part > 1.0 THEN"),
    (FB, "ELSIF part <= -half THEN", "ELSIF part < -1.0 THEN"),
    (FB, "IF acts AND (ipc.Error OR feedforward.Error) THEN", "IF acts AND feedforward.Error THEN"),
    (FB, "IF acts AND (ipc.Error OR feedforward.Error) THEN", "IF acts AND ipc.Error THEN"),
    (MAIN, "100 * _TaskInfo[GETCURTASKINDEXEX()].CycleTime", "_TaskInfo[GETCURTASKINDEXEX()].CycleTime"),
    (MAIN, "task_cycle_ns := 100 * _TaskInfo[GETCURTASKINDEXEX()].CycleTime", "task_cycle_ns := 0"),
    (MAIN, "damped_x.torque_offset;", "-damped_x.torque_offset;"),
    (MAIN, "GVL_axis_x.v_add := damped_x.v_add_mm_s", "GVL_axis_x.v_add := damped_x.v_add_calculated_mm_s"),
    (GVL, "velocity_increments : LREAL := 60.0", "velocity_increments : LREAL := 6.0"),
];

#[test]
fn planted_mistakes_are_found() {
    let project = Project::of_example();
    let rows = script(&project);
    let missed: Vec<&str> = (PLANTED.par_iter())
        .filter(|(file, old, new)| {
            let edit = |of: &str, text: String| if of == *file { swap(&text, old, new) } else { text };
            // What the engine refuses is found as well.
            project.try_program(edit).is_ok_and(|program| violations(&project, &program, &rows).is_empty())
        })
        .map(|(_, old, _)| *old)
        .collect();
    assert!(missed.is_empty(), "{} mistakes are not found: {missed:#?}", missed.len());
    println!("{} mistakes planted by hand, all found", PLANTED.len());
}

/// Without any one of its assignments the glue is wrong somewhere: in the life of an axis, beyond 32 bits, or where a self-test fails.
#[test]
fn each_lost_statement_is_found() {
    let [usual, held, failed] = [
        Project::of_example(),
        Project { increments: 1.0e6, ..Project::of_example() },
        Project { spoilt: Some("ipc"), ..Project::of_example() },
    ];
    let rows = [script(&usual), script(&held), failing(&failed)];
    let projects = [&usual, &held, &failed];
    let is_missed = |file, which| {
        let mut runs = projects.iter().zip(&rows);
        runs.all(|(project, rows)| violations(project, &project.without(file, which), rows).is_empty())
    };
    for file in [FB, MAIN] {
        let statements = usual.statements(file);
        let count = statements.len();
        let missed: Vec<&String> = (0..count)
            .into_par_iter()
            .filter(|&which| is_missed(file, which))
            .map(|which| &statements[which])
            .collect();
        assert!(missed.is_empty(), "{file}: {} of {count} can be lost: {missed:#?}", missed.len());
        println!("{file}: {count} statements taken away one by one, each one found");
    }
}
