//! The listings of the vendor's manuals on feedforward and on spindles, letter by letter, and what they say. No program of ours.

use crate::support::{commands, said};
use nc::Command::{End, Feedforward, Percentage, Position, Turn};
use nc::Direction::{Negative, Positive};
use nc::{Axis, Block, Command, PassedKind, Program, Target, read};

fn turn(direction: nc::Direction, rpm: f64) -> Command {
    Turn { spindle: 1, direction, rpm }
}

fn position(direction: nc::Direction, rpm: f64) -> Command {
    Position { spindle: 1, direction: Some(direction), rpm: Some(rpm), degrees: 180.0 }
}

#[test]
fn changeover_of_the_operation_mode() {
    let text = "%spindle-position
N30 S200 M4
N40 M19 S.POS=180 S1000 M4
N50 S200 M3
N60 M19 S.POS=180 S1000 M4
N70 S200 M4
N80 M19 S.POS=180 S1000 M3
M30
";
    let block = |line, number, command| Block { line, number, commands: vec![command] };
    let blocks = vec![
        block(2, Some(30), turn(Negative, 200.0)),
        block(3, Some(40), position(Negative, 1000.0)),
        block(4, Some(50), turn(Positive, 200.0)),
        block(5, Some(60), position(Negative, 1000.0)),
        block(6, Some(70), turn(Negative, 200.0)),
        block(7, Some(80), position(Positive, 1000.0)),
        block(8, None, End),
    ];
    assert_eq!(read(text), Ok(Program { name: Some("spindle-position".to_owned()), blocks, passed: vec![] }));
}

#[test]
fn effect_of_the_switch_back_speed() {
    let text = "%spindle-position\nN10 M3 S1000\nN20 M19 S.POS=180 M4 S50\nM30\n";
    assert_eq!(commands(text), [[turn(Positive, 1000.0)], [position(Negative, 50.0)]]);
}

/// Its second comment has no end, and neither has the first.
#[test]
fn positioning_above_the_changeover_speed() {
    let text = "%spindle-position
(antr.sai_op_mode_change.v_velocity_control_on 1200000
( -> 200 rpm
(antr.sai_op_mode_change.v_position_control_on 600000
( -> 100 rpm

N10 M4 S1000
N20 M19 S.POS=180 M4 S500
M30
";
    assert_eq!(commands(text), [[turn(Negative, 1000.0)], [position(Negative, 500.0)]]);
    let lines: Vec<usize> = read(text).expect("no mistake").blocks.iter().map(|block| block.line).collect();
    assert_eq!(lines, [7, 8, 9]);
}

const AXES: &str = "G135                (Select feedforward control; Weighting)
(100% for all axes)
G136 X80 Y95 Z0    (Weighting; In this case the Z axis)
(has no feedforward control)
";

/// A listing that is not a whole program: its end is that of the file.
#[test]
fn feedforward_of_axes() {
    let program = read(AXES).expect("no mistake");
    let ends: Vec<_> = program.passed.iter().map(|passed| (passed.kind, passed.line, passed.column)).collect();
    assert_eq!(ends, [(PassedKind::NoEnd, 3, 16)]);
    let percentage = |axis, percent| Percentage { target: Target::Axis(axis), percent };
    assert_eq!(
        commands(&format!("{AXES}M30")),
        [
            vec![Feedforward { target: Target::Axes, on: true }],
            vec![percentage(Axis::X, 80), percentage(Axis::Y, 95), percentage(Axis::Z, 0)],
        ]
    );
}

/// The page is too narrow for two comments of this listing.
const SPINDLES: &str = include_str!("spindles.nc");

#[test]
fn feedforward_of_spindles() {
    let on = |spindle, on| Feedforward { target: Target::Spindle(spindle), on };
    let percentage = |spindle, percent| Percentage { target: Target::Spindle(spindle), percent };
    let one_line_each = SPINDLES.replace("\n%)", " %)").replace("\nS1)", " S1)");
    assert_eq!(
        commands(&format!("{one_line_each}M30")),
        [
            vec![on(1, true)],
            vec![percentage(1, 80)],
            vec![on(1, false)],
            vec![on(2, true), percentage(2, 90)],
            vec![percentage(2, 0)],
            vec![on(1, true)],
        ]
    );
}

#[test]
fn feedforward_of_spindles_as_the_page_breaks_it() {
    assert_eq!(
        said(&format!("{SPINDLES}M30")),
        [
            "3:1: error: found `%)`; allowed: `%` and the name of the program before the first block, once; write nothing here",
            "8:3: error: found `)` without its beginning; allowed: comments in `( )`; write `(` before the comment",
        ]
    );
}

/// Words that the running text names, without a listing.
#[test]
fn release_and_homing() {
    assert_eq!(
        commands("S[PUTAX]\nS[G74]\nM30"),
        [[Command::Release { spindle: 1 }], [Command::Home { target: Target::Spindle(1) }]]
    );
}

/// Selection and percentages may stand in one block.
#[test]
fn selection_with_percentages() {
    let expected = [
        Feedforward { target: Target::Axes, on: true },
        Percentage { target: Target::Axis(Axis::X), percent: 80 },
        Percentage { target: Target::Axis(Axis::Y), percent: 90 },
    ];
    assert_eq!(commands("G135 G136 X80 Y90\nM30"), std::slice::from_ref(&expected));
    assert_eq!(commands("G136 X80 Y90 G135\nM30"), [expected]);
}
