//! How programs of real controllers and CAM systems write what is read here.

use crate::support::{commands, said};
use nc::Command::{self, Dwell, End, Home, Move, Stop, Turn};
use nc::Direction::Positive;
use nc::{Axis, Target, read};

fn ends(text: &str) -> Vec<Vec<(String, f64)>> {
    let of = |command: &Command| match command {
        Move { axes, .. } => Some(axes.iter().map(|(axis, to)| (axis.to_string(), *to)).collect()),
        _ => None,
    };
    commands(text).iter().flatten().filter_map(of).collect()
}

fn to(axes: &[(&str, f64)]) -> Vec<(String, f64)> {
    axes.iter().map(|(axis, to)| ((*axis).to_owned(), *to)).collect()
}

#[test]
fn spellings_of_one_program() {
    let expected = commands("N10 G00 X1 Y-2\nN20 M3 S500\nN30 G01 X3 F600\nN40 M5\nM30");
    for text in [
        "N10G0X1Y-2\nN20M03S500\nN30G1X3F600\nN40M05\nN50M2",
        "N10G00X1.Y-2.\nN20M03S500.\nN30G01X3.F600.\nN40M05\nN50M30",
        "n10 g00 x1. y-2.0\nm3 s500\nN30 g01 x+3 f600.\nm5\nm02",
        "G 0 X 1 Y -2\nS500\nM3\nG 1 X 3 F 600\nM 5\nM 30",
        "%\nO1000 (PART)\n:1\nG0 X=1 Y=-2\nM3 S=500\nG1 X=3 F=600\nM5\nM30\n%\n",
        "\u{feff}\0N10 G0 X1 Y-2\rM3 S500\rG1 X3 F600\rM5\rM30\u{1a}",
    ] {
        assert_eq!(commands(text), expected, "{text:?}");
    }
}

#[test]
fn comments() {
    let expected = commands("G0 X1\nM30");
    for text in [
        "; G0 X5\n// G0 X5\n# G0 X5\nG0 X1 ; G0 X5\nM30 // end",
        "#COMMENT BEGIN\nG2 X5 [ é\n#COMMENT END\nG0 X1\nM30",
        "#comment  begin G2\n G3 #comment\tend G0 X1\nM30",
        "G0 (X5 (D=3) X6) X1 (and open\nM30",
    ] {
        assert_eq!(commands(text), expected, "{text:?}");
    }
    assert_eq!(
        said("G0 X1\n #COMMENT BEGIN\nM30"),
        [
            "2:2: error: found `#COMMENT BEGIN`; allowed: a comment with its end; write `#COMMENT END` in a line of its own"
        ]
    );
}

#[test]
fn positions_stay_absolute_or_incremental() {
    assert_eq!(
        ends("G0 X10 Y.5\nX-.5\nG91 X1. Y1\nG1 Y-2 F1\nG90\nX3\nM30"),
        [
            to(&[("X", 10.0), ("Y", 0.5)]),
            to(&[("X", -0.5)]),
            to(&[("X", 0.5), ("Y", 1.5)]),
            to(&[("Y", -0.5)]),
            to(&[("X", 3.0)]),
        ]
    );
    assert_eq!(ends("G91 G0 X5\nG74 X1\nX2\nM30"), [to(&[("X", 5.0)]), to(&[("X", 2.0)])]);
}

/// Lengths and feeds, not angles.
#[test]
fn inches() {
    for inch in ["G20", "G70"] {
        let text = format!("{inch} G1 X1 A90 F10\nG21\nX1\nG71 X2 F10\nM30");
        assert_eq!(ends(&text), [to(&[("X", 25.4), ("A", 90.0)]), to(&[("X", 1.0)]), to(&[("X", 2.0)])]);
        let feeds: Vec<_> = commands(&text).into_iter().flatten().collect();
        let feeds: Vec<_> =
            feeds.iter().map(|of| if let Move { feed_mm_min, .. } = of { *feed_mm_min } else { None }).collect();
        assert_eq!(feeds, [Some(254.0), Some(254.0), Some(10.0)]);
    }
}

#[test]
fn a_feed_and_a_motion_stay_in_force() {
    let moves = commands("F100\nG1 X1\nX2\nG0 X3 F200\nX4\nG1\nX5\nM30");
    let of = |command: &Command| {
        if let Move { rapid, feed_mm_min, .. } = command { (*rapid, *feed_mm_min) } else { panic!() }
    };
    let found: Vec<_> = moves.iter().flatten().map(of).collect();
    assert_eq!(found, [(false, Some(100.0)), (false, Some(100.0)), (true, None), (true, None), (false, Some(200.0))]);
}

#[test]
fn a_preset_gives_the_position_another_number() {
    assert_eq!(
        ends("G0 X10\nG92 X2\nX3\nG91 X1\nG90 G92.1\nX5\nM30"),
        [to(&[("X", 10.0)]), to(&[("X", 11.0)]), to(&[("X", 12.0)]), to(&[("X", 5.0)])]
    );
}

#[test]
fn other_axes() {
    assert_eq!(
        ends("G0 A1 B2 C3 U4 V5 W6 E7\nX1=8 Y12=-9\nM30"),
        [
            to(&[("A", 1.0), ("B", 2.0), ("C", 3.0), ("U", 4.0), ("V", 5.0), ("W", 6.0), ("E", 7.0)]),
            to(&[("X1", 8.0), ("Y12", -9.0)]),
        ]
    );
    assert_eq!(commands("G74 A1\nM30"), [[Home { target: Target::Axis(Axis::named("a").expect("an axis")) }]]);
    for name in ["", "P", "X01", "X100", "XY", "X-1", "\u{e9}"] {
        assert_eq!(Axis::named(name), None, "{name}");
    }
}

/// A dwell of 0 is one, on every controller.
#[test]
fn times_of_dwells() {
    for (text, seconds) in [
        ("G04 X0", 0.0),
        ("G4 X2.5", 2.5),
        ("G4 F0.5", 0.5),
        ("G04 U1", 1.0),
        ("G4 P1.5", 1.5),
        ("G4 P0", 0.0),
        ("G4 P99", 99.0),
        ("G4 P100", 0.1),
        ("#TIME 2", 2.0),
        ("#TIME 0", 0.0),
    ] {
        assert_eq!(commands(&format!("{text}\nM30")), [[Dwell { seconds }]], "{text}");
    }
    // The time is not a feed, and a spindle and a setting may stand with it.
    let turn = Turn { spindle: 1, direction: Positive, rpm: 5.0 };
    assert_eq!(
        commands("G1 X1 F7\nG90 M3 S5 G4 F2\nX2\nM30")[1..],
        [
            vec![turn, Dwell { seconds: 2.0 }],
            vec![Move { rapid: false, axes: vec![(Axis::X, 2.0)], feed_mm_min: Some(7.0) }]
        ]
    );
}

#[test]
fn speeds_stay_in_force() {
    let turn = |rpm| vec![Turn { spindle: 1, direction: Positive, rpm }];
    assert_eq!(
        commands("S100\nM3\nM5 S200\nM3\nS300\nM5\nM30"),
        [turn(100.0), vec![Stop { spindle: 1 }], turn(200.0), turn(300.0), vec![Stop { spindle: 1 }]]
    );
    assert_eq!(commands("M3\nM30"), [turn(0.0)]);
}

/// The end may stand with other words, be the closing `%`, or that of the file.
#[test]
fn ends_of_programs() {
    for text in ["M3 S1 M30", "M3 S1 M2\nG2 X1", "M3 S1\n%\nhello", "M3 S1"] {
        let blocks = read(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}")).blocks;
        let commands: Vec<Command> = blocks.into_iter().flat_map(|block| block.commands).collect();
        assert_eq!(commands, [Turn { spindle: 1, direction: Positive, rpm: 1.0 }, End], "{text}");
    }
}
