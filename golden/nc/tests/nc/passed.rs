//! What is passed over: each kind with its count, its first place and its words.

use nc::{Command, PassedKind, read};

fn passed(text: &str) -> Vec<(PassedKind, usize, usize, String, usize)> {
    let program = read(text).unwrap_or_else(|mistakes| panic!("{text}\n{mistakes:#?}"));
    program.passed.into_iter().map(|of| (of.kind, of.line, of.column, of.words.join(" "), of.count)).collect()
}

/// A kind with its first place, its words and its count.
fn one(text: &str, kind: PassedKind, place: (usize, usize), words: &str, count: usize) {
    assert_eq!(passed(text), [(kind, place.0, place.1, words.to_owned(), count)], "{text}");
}

#[test]
fn each_kind_once() {
    one("T1 M6\nG43 H1 D2 T12\nG49 G40\nM30", PassedKind::Tool, (1, 1), "T M6 G43 H D G49 G40", 8);
    one("M7\nM8 M9\nM0 M01\nM10 P5\nM30", PassedKind::Machine, (1, 1), "M7 M8 M9 M0 M01 M10", 6);
    one("O5\nG17 G94 G80\n#MSG [\"a ; b\"] ; c\nM30", PassedKind::Setting, (1, 1), "O G17 G94 G80 #MSG", 5);
    one("G64 P0.01\nG61\n#SLOPE [TYPE=STEP]\n#HSC ON\nM30", PassedKind::PathMode, (1, 1), "G64 G61 #SLOPE #HSC", 4);
    one("G54 G0 X1\nG54\nG59.1\nM30", PassedKind::Offset, (1, 1), "G54 G59.1", 3);
    one("G28 X1 Y0\nG91 G28 Z0\nG53 G0 Z5\nG30 P2\nM30", PassedKind::MachinePosition, (1, 1), "G28 G53 G30", 4);
    one("N1 G0 X1\n/N2 X2\n/2 X3\nM30", PassedKind::Skip, (2, 1), "", 2);
    one("G4 P5\nM30", PassedKind::DwellUnit, (1, 4), "G4 P5", 1);
    one("G0 X1\nG92 X0\nM30", PassedKind::Preset, (2, 1), "", 1);
    one("G0 X1\nG1 X2\nX3\nF1 X4\nM30", PassedKind::NoFeed, (2, 4), "", 2);
    one("G0 X1\n(end)\n", PassedKind::NoEnd, (1, 6), "", 1);
    one("M30\nG2 X1\n\nM30\n%", PassedKind::AfterEnd, (2, 1), "", 2);
    one("M104 S200\nM205 X8 F5\nM92 E415\nm66e0l0\nM30", PassedKind::Machine, (1, 1), "M104 M205 M92 M66", 4);
}

/// What acts, or is how the reader reads anyway, is not passed over.
#[test]
fn what_acts_is_not_passed_over() {
    for text in [
        "G90 G21 G0 X1\nM30",
        "G91 G20 G1 X1 F5\nM30",
        "%\nN10\nG0 X1 (a)\nM30\n%",
        "#COMMENT BEGIN\nT1\n#COMMENT END\nM30",
    ] {
        assert_eq!(passed(text), [], "{text}");
    }
}

/// A block that is not made moves nothing, and what it says of the motion stays in force.
#[test]
fn moves_to_the_machine_are_not_made() {
    let program = read("G0 X1\nG1 G53 X9 F5\nX2\nM30").expect("no mistake");
    let moves = program.blocks.iter().flat_map(|block| &block.commands).filter_map(|command| match command {
        Command::Move { rapid, axes, .. } => Some((*rapid, axes[0].1)),
        _ => None,
    });
    assert_eq!(moves.collect::<Vec<_>>(), [(true, 1.0), (false, 2.0)]);
}

#[test]
fn kinds_are_in_the_order_of_their_first_places() {
    let kinds: Vec<PassedKind> = passed("M8 T1\nG54\nT2\nM9\nM30").into_iter().map(|of| of.0).collect();
    assert_eq!(kinds, [PassedKind::Machine, PassedKind::Tool, PassedKind::Offset]);
}
