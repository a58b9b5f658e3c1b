//! Whatever the bytes, both readers answer; and the list of codes matches what is said.

use super::{IPC, read_list, read_set};
use generator::codes::CODES;
use generator::diagnostics::Report;
use proptest::prelude::*;

/// Pieces from which lists and sets are made, so that random files come past the first line.
fn pieces() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop_oneof![
        Just(IPC.to_owned()),
        Just("cycle_time = \"1ms\"\n[axis.X]\n".to_owned()),
        prop::sample::select(
            &[
                "stage[",
                "stage[0].",
                "filter[1].",
                "filter.",
                "]",
                "osc_damping",
                "mode",
                "fg_f0",
                "order",
                "type",
                "enable",
                "getriebe[0].dynamik.vb_max",
                "\n[axis.",
                "[[axis.X.",
                "]]\n",
                "stage = [{ ",
                "filter = [{",
                " }]",
                "DIRECT",
                "ALLPASS",
                "\n",
                " ",
                "\t",
                " = ",
                "#",
                "(",
                "\"",
                "'",
                "\r\n",
                ".",
                "0x",
                "1",
                "-1",
                "1e9",
                "nan",
                "53",
                "\u{e4}"
            ][..]
        )
        .prop_map(str::to_owned),
        any::<u64>().prop_map(|n| n.to_string()),
        any::<f64>().prop_map(|x| x.to_string()),
    ];
    prop::collection::vec(piece, 0..60).prop_map(|pieces| pieces.concat().into_bytes())
}

/// A valid list and a valid set, which nothing is said about.
fn valid() -> [String; 2] {
    let list = super::direct("").replace("ipc.", IPC);
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples");
    let set = std::fs::read_to_string(format!("{examples}/machine.toml")).expect("the example is there");
    [list, set]
}

/// One change of a file.
#[derive(Clone, Debug)]
enum Change {
    Flip { at: usize, bit: u8 },
    Put { at: usize, byte: u8 },
    Cut { at: usize, length: usize },
    Copy { from: usize, length: usize, to: usize },
    End { at: usize },
}

fn changes() -> impl Strategy<Value = Vec<Change>> {
    let at = || any::<usize>();
    let change = prop_oneof![
        4 => (at(), 0..8_u8).prop_map(|(at, bit)| Change::Flip { at, bit }),
        2 => (at(), any::<u8>()).prop_map(|(at, byte)| Change::Put { at, byte }),
        2 => (at(), 1..40_usize).prop_map(|(at, length)| Change::Cut { at, length }),
        2 => (at(), 1..200_usize, at()).prop_map(|(from, length, to)| Change::Copy { from, length, to }),
        1 => at().prop_map(|at| Change::End { at }),
    ];
    prop::collection::vec(change, 1..6)
}

fn changed(text: &str, changes: &[Change]) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for change in changes {
        let length = bytes.len();
        let place = |at: usize| at % (length + 1);
        match *change {
            Change::Flip { at, bit } => {
                if let Some(byte) = bytes.get_mut(place(at)) {
                    *byte ^= 1 << bit;
                }
            }
            Change::Put { at, byte } => bytes.insert(place(at), byte),
            Change::Cut { at, length: cut } => drop(bytes.drain(place(at)..length.min(place(at) + cut))),
            Change::Copy { from, length: copied, to } => {
                let piece = bytes[place(from)..length.min(place(from) + copied)].to_vec();
                bytes.splice(place(to)..place(to), piece);
            }
            Change::End { at } => bytes.truncate(place(at)),
        }
    }
    bytes
}

/// What is said has a place in the file, a code of the list, and a line for each of its parts.
fn assert_well_said(bytes: &[u8], report: &Report) {
    let lines = bytes.split(|byte| *byte == b'\n').count();
    for diagnostic in &report.diagnostics {
        assert!(diagnostic.place.line <= lines, "{diagnostic}");
        assert!(CODES.iter().any(|code| code.code == diagnostic.code), "{diagnostic}");
        assert!(!diagnostic.to_string().contains(|c: char| c.is_control() && c != '\n'), "{diagnostic}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]
    #[test]
    fn changes_of_valid_files(changes in changes()) {
        let [list, set] = valid();
        let bytes = changed(&list, &changes);
        assert_well_said(&bytes, &read_list(&bytes).1);
        let bytes = changed(&set, &changes);
        // The lists that it names are not there: whatever else is wrong is said beside that.
        assert_well_said(&bytes, &read_set(&bytes).1);
    }
}

proptest! {
    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        let _ = read_list(&bytes);
        let _ = read_set(&bytes);
    }

    #[test]
    fn any_pieces(bytes in pieces()) {
        let _ = read_list(&bytes);
        let _ = read_set(&bytes);
    }

    #[test]
    fn what_is_accepted_is_within_its_range(f0 in any::<f64>(), q in any::<f64>(), num in any::<u64>(), order in any::<i8>()) {
        let stage = format!("{IPC}stage[0]");
        let (set, report) = read_list(format!(
            "{stage}.mode DIRECT\n{stage}.filter.fg_f0 {f0:e}\n{stage}.filter.q_factor {q}\n{stage}.weight_fact_num {num}\n\
             {stage}.filter.order {order}\n"
        ));
        let valid = (1e-3..=450.0).contains(&f0) && (1.0..=10.0).contains(&q) && (1..u64::from(u32::MAX)).contains(&num)
            && (1..=3).contains(&order);
        prop_assert_eq!(set.is_some(), valid, "{}", report);
    }
}

/// A hostile file must not make the messages cost more than the file: here one line of a megabyte with 50,000 faults.
#[test]
fn one_long_line() {
    let many = "{ '\u{e4}\u{e4}' = 1, b = 2 }, ".repeat(50_000);
    let (_, report) = read_set(format!("cycle_time = \"1ms\"\n[axis.X]\ngetriebe = [{many}]"));
    let last = report.diagnostics.last().unwrap().to_string();
    assert_eq!(report.diagnostics.len(), 1001);
    assert_eq!(last, "set.toml: error[AX010]: 99000 more messages are not listed");
}

#[test]
fn deep_nesting() {
    for (opening, closing) in [("[", "]"), ("{ a = ", " }"), ("a.", "a = 1")] {
        let (_, report) = read_set(format!("x = {}{}", opening.repeat(100_000), closing.repeat(100_000)));
        assert!(report.has_errors());
        let (_, report) = read_set(format!("{}a = 1", opening.repeat(100_000)));
        assert!(report.has_errors());
    }
    let _ = read_list(format!("{}x 1\n{IPC}{} 1", "a.".repeat(1_000_000), "[".repeat(1_000_000)));
}

/// Every code is asserted somewhere in these tests; those of the command line in its own.
#[test]
fn every_code_has_a_test() {
    let tests = [
        include_str!("advice.rs"),
        include_str!("control.rs"),
        include_str!("every_rule.rs"),
        include_str!("arbitrary.rs"),
        include_str!("files.rs"),
        include_str!("gantry.rs"),
        include_str!("gear.rs"),
        include_str!("inert.rs"),
        include_str!("list.rs"),
        include_str!("looks_wrong.rs"),
        include_str!("phase.rs"),
        include_str!("rules.rs"),
        include_str!("set.rs"),
        include_str!("spindle.rs"),
        include_str!("spindle_drive.rs"),
        include_str!("spindle_limits.rs"),
        include_str!("values.rs"),
        include_str!("../real_files/kinds.rs"),
        include_str!("../real_files/mistakes.txt"),
        include_str!("../real_files/nc_axes.rs"),
        include_str!("../real_files/projects.rs"),
        include_str!("../response_file/defects.txt"),
        include_str!("../response_file/doubtful.txt"),
        include_str!("../response_file/sinumerik.txt"),
        include_str!("../../../tests/tests/stability/examples.rs"),
        include_str!("../../cli/tests/front_door/messages.rs"),
        include_str!("../../cli/tests/manifest/main.rs"),
        include_str!("../../cli/tests/manifest/ways.rs"),
        include_str!("../../cli/tests/measure.rs"),
        include_str!("../../cli/tests/params_of.rs"),
        include_str!("../../cli/tests/recordings/evidence.rs"),
        include_str!("../../cli/tests/recordings/refused.rs"),
        include_str!("../../cli/tests/scenario.rs"),
    ];
    for code in CODES {
        assert!(tests.iter().any(|test| test.contains(code.code)), "{} has no test", code.code);
    }
}
