//! Units of recordings: stated, unknown, different in each column; and a response that is not 1 at low frequencies.

use super::plant::{
    self, A_LOAD, Columns, OF_EXCITED, OF_MOVES, V_CMD, V_COMMAND, V_EXCITE, V_MOTOR, X_ACTUAL, X_COMMAND, excited,
    moves, number,
};
use super::tune::{NAMES, SET, folder, tune};
use crate::{Run, axgen};
use serde_json::Value;
use std::sync::LazyLock;

static MOVES: LazyLock<Columns> = LazyLock::new(moves);
static EXCITED: LazyLock<Columns> = LazyLock::new(|| excited(8, 0.02));

/// A column, its name, and a factor.
type Change<'a> = (usize, &'a str, f64);

/// Columns of um/s, mm and m/s^2, some of them under another name and multiplied by a factor.
fn scaled(columns: &Columns, of: &[usize], changes: &[Change<'_>]) -> String {
    let mut columns = columns.clone();
    let mut names = NAMES;
    names[A_LOAD] = "a_load [m/s^2]";
    for (at, name, factor) in changes {
        names[*at] = name;
        columns[*at].iter_mut().for_each(|value| *value *= factor);
    }
    plant::csv(&names, &columns, of)
}

/// Both recordings, measured together.
fn measure(moves: &str, excited: &str) -> Run {
    let folder = folder(&[("m.csv", moves), ("e.csv", excited)]);
    axgen(&folder, &["measure", "m.csv", "--excited", "e.csv", "--json"])
}

/// The response at 20 Hz, and the side on which 53 Hz enter.
fn results(run: &Run) -> ([f64; 2], Value) {
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let json = run.json();
    let k = json["response"]["hz"].as_array().unwrap().iter().position(|hz| hz.as_f64().unwrap() >= 20.0).unwrap();
    let at = ["re", "im"].map(|key| json["response"][key][k].as_f64().unwrap());
    let is_line = |of: &&Value| of["channel"] == "a_load" && of["when"] == "driving";
    let line = json["vibrations"].as_array().unwrap().iter().find(is_line).unwrap();
    assert!((number(line, "hz") - 53.0).abs() < 0.1, "{line}");
    (at, line["source"].clone())
}

#[test]
fn units_change_neither_the_response_nor_the_side() {
    let plain = scaled(&MOVES, &OF_MOVES, &[]);
    let ([re, im], side) = results(&measure(&plain, &scaled(&EXCITED, &OF_EXCITED, &[])));
    assert_eq!(side, "motor");
    let parts = [V_COMMAND, V_MOTOR, V_EXCITE, A_LOAD];
    let cases: [(&[usize], &[Change<'_>]); 4] = [
        (&OF_EXCITED, &[(V_MOTOR, "v_motor [mm/min]", 0.06)]),
        (&OF_EXCITED, &[(V_MOTOR, "v_motor [mm/s]", 1e-3), (A_LOAD, "a_load [g]", 1.0 / 9.80665)]),
        // Without v_cmd, the sum of its parts in two units.
        (&parts, &[(V_COMMAND, "v_command [mm/s]", 1e-3)]),
        (&parts, &[(V_EXCITE, "v_excite [mm/s]", 1e-3), (A_LOAD, "a_load [mm/s^2]", 1e3)]),
    ];
    for (of, changes) in cases {
        let ([a, b], side) = results(&measure(&plain, &scaled(&EXCITED, of, changes)));
        assert!((a - re).hypot(b - im) < 1e-3, "{changes:?}: {a} {b}, {re} {im}");
        assert_eq!(side, "motor", "{changes:?}");
    }
    // Without a unit, 200 times as large: whether it is m/s^2 as in the move is not known.
    let run = measure(&plain, &scaled(&EXCITED, &OF_EXCITED, &[(A_LOAD, "a_load", 200.0)]));
    let (_, side) = results(&run);
    assert!(side.is_null() && run.out.contains("AX514"), "{side}");
}

/// What is said of units that the channels contradict, or that need not be those of the values.
#[test]
fn units_that_are_doubtful() {
    let plain = |changes: &[Change<'_>]| scaled(&MOVES, &OF_MOVES, changes);
    let error = |name: &str, factor: f64| {
        let mut columns = MOVES.clone();
        columns[X_ACTUAL].iter_mut().zip(&MOVES[X_COMMAND]).for_each(|(x, command)| *x = command - *x);
        scaled(&columns, &OF_MOVES, &[(X_ACTUAL, name, factor)])
    };
    let rows = plain(&[]).lines().skip(1).fold(String::new(), |text, row| text + &row[6..].replace(',', "\t") + "\n");
    let export = |factor: &str, unit: &str, ty: &str| {
        let ones = "\t1".repeat(3);
        format!(
            "Name\tP\n\nName\tx_command\tx_actual\tv_command\tv_motor\ta_load\nData-Type\tBIT\tBIT\tBIT\t{ty}\tBIT\n\
             SampleTime[ms]\t1\t1{ones}\nScaleFactor{ones}\t{factor}\t1\nUnit\tmm\tmm\tum/s\t{unit}\tm/s^2\n\n{rows}"
        )
    };
    let scaling = "warning[AX528]: v_motor has ScaleFactor 0.001, Offset 0: its values are taken as scaled, in";
    let kv = "warning[AX528]: following_error has no unit: um are assumed, with which Kv is 1.49";
    let differs = "times as large as the change of x_actual, in the units that are stated";
    for (what, text, said) in [
        ("right", plain(&[]), &[][..]),
        ("a position in the other unit", plain(&[(V_MOTOR, "v_motor [mm/s]", 1.0)]), &[differs]),
        ("an assumed error", error("following_error", 1e4), &[kv]),
        ("a stated error", error("following_error [10^-1 um]", 1e4), &[]),
        ("scaled by 1", export("1", "um/s", "REAL64"), &[]),
        ("scaled", export("0,001", "um/s", "REAL64"), &[scaling]),
        ("scaled integers", export("0,001", "um/s", "INT32"), &[]),
        ("raw", export("0,001", "mm/s", "REAL64"), &[scaling, differs]),
    ] {
        let at = folder(&[("m.csv", &text)]);
        let run = axgen(at.path(), &["measure", "m.csv"]);
        let found = [scaling, kv, differs].into_iter().filter(|part| run.err.contains(part)).collect::<Vec<_>>();
        assert_eq!(found, said, "{what}: {}", run.err);
        assert_eq!(run.code, i32::from(said.contains(&differs)), "{what}: {}", run.err);
    }
    let folder = folder(&[("moves.csv", &error("following_error", 1e3))]);
    std::fs::write(folder.path().join("set.toml"), SET.replace("kv = 2000", "kv = 15000")).unwrap();
    let run = tune(&folder, &[]);
    assert!(run.err.contains("um are assumed, with which Kv is 14.86"), "{}", run.err);
}

#[test]
fn a_motor_that_does_not_follow_slow_commands_is_refused() {
    let of = |name| scaled(&MOVES, &OF_MOVES, &[(V_MOTOR, name, 0.06), (V_COMMAND, "v_command", 1.0)]);
    let excited = scaled(&EXCITED, &OF_EXCITED, &[(V_MOTOR, "v_motor", 0.06), (V_CMD, "v_cmd", 1.0)]);
    let folder = folder(&[("moves.csv", &of("v_motor")), ("e.csv", &excited)]);
    for run in [tune(&folder, &["--excited", "e.csv"]), axgen(&folder, &["measure", "e.csv"])] {
        assert_eq!(run.code, 1, "{}{}", run.out, run.err);
        let expected = "e.csv: error[AX340]: the measured response: 0.0";
        assert!(run.err.contains(expected) && run.err.contains("16.7"), "{}", run.err);
        assert!(!run.out.contains("stage["), "{}", run.out);
    }
}

#[test]
fn an_unknown_unit_is_a_mistake() {
    let folder = folder(&[("m.csv", &scaled(&MOVES, &OF_MOVES, &[(V_MOTOR, "v_motor [furlong/h]", 1.0)]))]);
    let run = axgen(&folder, &["measure", "m.csv"]);
    assert_eq!(run.code, 2, "{}{}", run.out, run.err);
    assert!(run.err.contains("m.csv:1:56: error[AX015]: the unit `furlong/h` of v_motor\n"), "{}", run.err);
    assert!(run.err.contains("allowed: um/s, mm/s, m/s, m/min, mm/min, 0.001 deg/s, deg/s, deg/min"), "{}", run.err);
    // An index is not a unit, nor need brackets in the name of a mapped column be one.
    for (name, said) in
        [("v[1]", ""), ("motor(X)", "warning[AX528]: the unit of v_motor, `X`, is not known: um/s is assumed")]
    {
        let folder = super::tune::folder(&[("m.csv", &scaled(&MOVES, &OF_MOVES, &[(V_MOTOR, name, 1.0)]))]);
        let run = axgen(&folder, &["measure", "m.csv", "--map", &format!("{name}=v_motor")]);
        assert!(run.code == 0 && run.err.contains(said), "{}{}", run.out, run.err);
    }
}
