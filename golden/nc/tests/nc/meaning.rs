//! What programs say that the manuals do not show: forms of numbers, what stays in force, what a block may hold together.

use crate::support::commands;
use nc::Command::{self, Dwell, Feedforward, Home, Move, Percentage, Position, Release, Stop, Turn};
use nc::Direction::{Negative, Positive};
use nc::{Axis, Block, Program, Target, read};

#[test]
fn the_smallest_program() {
    for text in ["M30", "M30\n", "\n(nothing)\n\tM30 \r\n\r\n(and no more", "M30(end)"] {
        let line = if text.starts_with('\n') { 3 } else { 1 };
        let blocks = vec![Block { line, number: None, commands: vec![Command::End] }];
        assert_eq!(read(text), Ok(Program { name: None, blocks, passed: vec![] }), "{text:?}");
    }
}

#[test]
fn names_and_numbers_of_blocks() {
    let program =
        read("(first a comment)\n%Part_7-b (its name)\nN0 G135\n\nN999999999 G137\nN10 M30").expect("no mistake");
    assert_eq!(program.name.as_deref(), Some("Part_7-b"));
    let places: Vec<_> = program.blocks.iter().map(|block| (block.line, block.number)).collect();
    assert_eq!(places, [(3, Some(0)), (5, Some(999_999_999)), (6, Some(10))]);
}

#[test]
fn moves_and_their_feed() {
    let to = |rapid, axes: &[(Axis, f64)], feed_mm_min| Move { rapid, axes: axes.to_vec(), feed_mm_min };
    assert_eq!(
        commands("G01 Y-2.5 X+10 F600\nG00 Z0\nG01 X0\nG01 F0.5 X-0\nM30"),
        [
            [to(false, &[(Axis::Y, -2.5), (Axis::X, 10.0)], Some(600.0))],
            [to(true, &[(Axis::Z, 0.0)], None)],
            [to(false, &[(Axis::X, 0.0)], Some(600.0))],
            [to(false, &[(Axis::X, 0.0)], Some(0.5))],
        ]
    );
}

/// Nothing may depend on how a zero was written.
#[test]
fn no_number_is_a_negative_zero() {
    let blocks = commands("M19 S.POS=-0\nM30");
    let Position { degrees, .. } = blocks[0][0] else { panic!("{blocks:?}") };
    assert_eq!(degrees.to_bits(), 0);
}

#[test]
fn numbers_to_their_last_digit() {
    assert_eq!(
        commands("M3 S999999999.999999\nM30"),
        [[Turn { spindle: 1, direction: Positive, rpm: 999_999_999.999_999 }]]
    );
    assert_eq!(commands("G04 X0.000001\nM30"), [[Dwell { seconds: 0.000_001 }]]);
}

/// The limits of a percentage are those of the block that uses it.
#[test]
fn percentages_are_kept_as_written() {
    let percentage = |target, percent| Percentage { target, percent };
    assert_eq!(
        commands("G136 X150 Y-5\nS99[G136=+101]\nM30"),
        [
            vec![percentage(Target::Axis(Axis::X), 150), percentage(Target::Axis(Axis::Y), -5)],
            vec![percentage(Target::Spindle(99), 101)],
        ]
    );
}

#[test]
fn a_speed_alone_is_for_the_direction_in_force() {
    let turn = |direction, rpm| vec![Turn { spindle: 1, direction, rpm }];
    assert_eq!(
        commands("M4 S100\nS200\nG135\nS2[PUTAX]\nS0\nM3 S5\nS6\nM5\nM30"),
        [
            turn(Negative, 100.0),
            turn(Negative, 200.0),
            vec![Feedforward { target: Target::Axes, on: true }],
            vec![Release { spindle: 2 }],
            turn(Negative, 0.0),
            turn(Positive, 5.0),
            turn(Positive, 6.0),
            vec![Stop { spindle: 1 }],
        ]
    );
}

#[test]
fn positioning_with_less() {
    let position = |direction, rpm, degrees| Position { spindle: 1, direction, rpm, degrees };
    assert_eq!(
        commands("S.POS=-90.5 M19\nM19 M3 S.POS=0\nM19 S10 S.POS=720\nM30"),
        [[position(None, None, -90.5)], [position(Some(Positive), None, 0.0)], [position(None, Some(10.0), 720.0)],]
    );
}

#[test]
fn homing_of_axes_at_once() {
    let home = |axis| Home { target: Target::Axis(axis) };
    assert_eq!(commands("G74 Z1 X1\nM30"), [[home(Axis::Z), home(Axis::X)]]);
}

/// The order of the words does not matter, that of the commands is fixed.
#[test]
fn spindle_and_axes_in_one_block() {
    let expected = [
        Turn { spindle: 1, direction: Positive, rpm: 100.0 },
        Move { rapid: true, axes: vec![(Axis::X, 1.0)], feed_mm_min: None },
    ];
    assert_eq!(commands("G00 X1 M3 S100\nS100 G00 M3 X1\nM30"), [expected.clone(), expected]);
    assert_eq!(
        commands("G137 S2[ G137\t]\nM30"),
        [[Feedforward { target: Target::Spindle(2), on: false }, Feedforward { target: Target::Axes, on: false }]]
    );
}

#[test]
fn comments_hold_any_letter() {
    assert_eq!(
        commands("G135(µ ; % [ é)(once more) (and open\nM30 (µ"),
        [[Feedforward { target: Target::Axes, on: true }]]
    );
}
