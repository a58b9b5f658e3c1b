//! The example `examples/twincat`: its program, its function blocks and the emitted blocks of two axes run together
//! in the strict engine, cycle by cycle, against the reference blocks and lives written by hand; planted mistakes are
//! found.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::print_stdout, reason = "`--nocapture` shows how many mistakes were planted and found")]

mod checks;
mod lives;
mod planted;
mod project;
mod script;
mod tuning;
mod world;

use axgen_tests::environment::by_depth;
use checks::violations;
use lives::{failing, lives, task};
use planted::planted;
use portable::Literal;
use project::{BLOCKS, LISTS, MAIN, Project};
use rayon::prelude::*;
use world::get;

/// The page of the example.
const PAGE: &str = include_str!("../../../docs/twincat.md");

#[test]
fn the_glue_does_what_the_reference_and_the_lives_say() {
    let project = Project::of_example();
    let program = project.program(|_, text| text);
    let lives = lives(&project);
    let said = violations(&project, &program, &lives);
    assert!(said.is_empty(), "{} rows:\n{}", lives[0].len(), said.join("\n"));
    let acting = lives.iter().flatten().filter(|row| row.state == 4).count();
    shown(&format!("2 axes, {} cycles, {acting} times a block that may act, no difference", lives[0].len()));
}

/// What the page shows of a run.
fn shown(line: &str) {
    println!("{line}");
    assert!(PAGE.contains(line), "docs/twincat.md shows something else than `{line}`");
}

/// What a first-order filter does to a vibration, and the lag that an offset makes which is held.
#[test]
fn the_numbers_of_the_page_follow_from_its_formulas() {
    for milliseconds in [1.0, 4.0, 10.0] {
        let at = |hertz: f64| {
            let turn = std::f64::consts::TAU * hertz * milliseconds / 1000.0;
            format!("{:.0} degrees, {:.2}", libm::atan(turn).to_degrees(), 1.0 / (1.0 + turn * turn).sqrt())
        };
        let row = format!("| {milliseconds} ms | {} | {} |", at(31.0), at(53.0));
        assert!(PAGE.contains(&row), "{row}");
    }
    let project = Project::of_example();
    let [x, z] = project.axes.each_ref().map(|axis| axis.limit() / 1000.0);
    assert!(PAGE.contains(&format!("{x} mm/s for X, {z} mm/s for Z")));
    assert!(PAGE.contains(&format!("at most {} mm for {x} mm/s and 20/s", x / 20.0)));
    assert!(PAGE.contains(&format!("after some {} cycles", project.axes[0].tested().div_ceil(10) * 10)));
}

/// Another cycle of the task, calls that are missing, a breakpoint that the machine outlives.
#[test]
fn skipped_calls_are_seen() {
    let project = Project::of_example();
    let said = violations(&project, &project.program(|_, text| text), &task(&project));
    assert!(said.is_empty(), "{}", said.join("\n"));
}

/// What the drive cannot take is held at the end of its range, and does not come back with the other sign.
#[test]
fn an_offset_beyond_32_bits_is_held() {
    let project = Project::with_increments(1.0e6);
    let said = violations(&project, &project.program(|_, text| text), &lives(&project));
    assert!(said.is_empty(), "{}", said.join("\n"));
}

/// A block of which one number is another fails its self-test: then it never acts, whatever the operator does.
#[test]
fn a_block_that_fails_its_self_test_never_acts() {
    for block in ["ipc", "feedforward"] {
        let project = Project::with_spoilt(block);
        let lives = failing(&project);
        let said = violations(&project, &project.program(|_, text| text), &lives);
        assert!(said.is_empty(), "{block}:\n{}", said.join("\n"));
    }
}

/// A PLC that stops in the middle of a motion sends 0; when it starts again the axis still moves. Everything begins
/// anew then: the first cycle adds nothing but the weight, the self-tests come first, and the fade begins at 0.
#[test]
fn a_plc_that_starts_while_the_axis_moves_begins_at_0() {
    let project = Project::of_example();
    let program = project.program(|_, text| text);
    let lives = lives(&project);
    let at =
        (lives[0].iter().zip(&lives[1])).rposition(|(x, z)| x.state == 4 && z.state == 4 && !z.not_moving).unwrap();
    let tested = project.axes.each_ref().map(|axis| axis.tested());
    let mut run = program.start(&[], &[], &[]).unwrap();
    let mut moved = [false; 2];
    for cycle in 0..tested[0].max(tested[1]) + 200 {
        world::task(&mut run, 10_000, u32::try_from(cycle).unwrap() + 1);
        for ((axis, life), (moved, tested)) in project.axes.iter().zip(&lives).zip(moved.iter_mut().zip(tested)) {
            let turn = std::f64::consts::TAU * 0.053 * cycle as f64;
            let mut row = life[at].clone();
            row.velocity = 100.0 + 5.0 * turn.sin();
            world::axis(&mut run, axis.letter, &row);
            if cycle > 0 {
                let list = |name: &str| get(&run, &format!("GVL_axis_{}.{name}", axis.letter));
                let (velocity, torque) = (list("velocity_offset"), list("torque_offset"));
                if cycle <= tested {
                    assert_eq!(
                        (velocity, torque),
                        (Literal::I32(0), Literal::I32(if axis.inverted { -row.weight } else { 0 }))
                    );
                } else {
                    let Literal::I32(velocity) = velocity else { panic!("60B1h is a DINT") };
                    let since = (cycle - tested) as f64;
                    assert!(
                        f64::from(velocity).abs() <= axis.limit() * axis.increments * since / 100.0,
                        "{cycle}: {velocity}"
                    );
                    *moved |= velocity != 0;
                }
            }
        }
        run.cycle(&[], &mut Vec::new());
    }
    assert_eq!(moved, [true; 2]);
}

/// Two axes from one text: the function blocks name none, and what names one differs by its letter alone, and by the
/// numbers of the machine.
#[test]
fn the_axes_share_one_text() {
    let project = Project::of_example();
    for file in BLOCKS {
        let text = project.text(file).to_lowercase().replace("axis_ref", "");
        assert!(!text.contains("axis_") && !text.contains("gvl") && !text.contains("fb_axis"), "{file}");
    }
    let main = project.text(MAIN);
    let sections: Vec<&str> = main.split("// Axis ").skip(1).collect();
    let [x, z] = sections[..] else { panic!("two sections") };
    let of_z = z.split("]]>").next().unwrap().trim().replace("_z", "_x").replacen('Z', "X", 1);
    assert_eq!(x.trim(), of_z);
    // Declarations up to their start values.
    let code = |name: &str| -> Vec<String> {
        let text = project.text(name);
        let lines = text.lines().filter(|line| line.contains(" : ") && !line.trim_start().starts_with("//"));
        lines.map(|line| line.split(" :=").next().unwrap().split(';').next().unwrap().to_owned()).collect()
    };
    assert!(code(LISTS[0]).len() > 20 && code(LISTS[0]) == code(LISTS[1]));
}

/// The text with something else instead of each of its occurrences.
fn swap(text: &str, old: &str, new: &str) -> String {
    assert!(text.contains(old), "{old:?} is there");
    text.replace(old, new)
}

#[test]
fn planted_mistakes_are_found() {
    let [usual, failed] = [Project::of_example(), Project::with_spoilt("ipc")];
    let runs = [(&usual, lives(&usual)), (&usual, task(&usual)), (&failed, failing(&failed))];
    let planted = planted();
    // The page shows what an exhaustive run does; a plain one plants half.
    let missed: Vec<&String> = (planted.par_iter().step_by(by_depth(2, 1, 1)))
        .filter(|[file, old, new]| {
            let edit = |of: &str, text: String| if of == file { swap(&text, old, new) } else { text };
            // What the engine refuses is found as well.
            runs.iter().all(|(project, lives)| {
                project.try_program(edit).is_ok_and(|program| violations(project, &program, lives).is_empty())
            })
        })
        .map(|[_, _, new]| new)
        .collect();
    assert!(planted.len() > 60);
    assert!(missed.is_empty(), "{} mistakes are not found: {missed:#?}", missed.len());
    shown(&format!("{} mistakes planted by hand, all found", planted.len()));
}

/// Without any one of its assignments the glue is wrong somewhere: in the lives of the axes, beyond 32 bits, or where
/// a self-test fails.
#[test]
fn each_lost_statement_is_found() {
    let [usual, held, failed] = [Project::of_example(), Project::with_increments(1.0e6), Project::with_spoilt("ipc")];
    let runs = [(&usual, lives(&usual)), (&usual, task(&usual)), (&held, lives(&held)), (&failed, failing(&failed))];
    let is_missed = |file, which| {
        runs.iter().all(|(project, lives)| violations(project, &project.without(file, which), lives).is_empty())
    };
    for file in BLOCKS.into_iter().chain([MAIN]) {
        let statements = usual.statements(file);
        let count = statements.len();
        let missed: Vec<&String> = (0..count)
            .into_par_iter()
            .step_by(by_depth(2, 1, 1))
            .filter(|&which| is_missed(file, which))
            .map(|which| &statements[which])
            .collect();
        assert!(missed.is_empty(), "{file}: {} of {count} can be lost: {missed:#?}", missed.len());
        shown(&format!("{file}: {count} statements taken away one by one, each one found"));
    }
}
