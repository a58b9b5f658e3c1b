//! Random files: whatever the bytes, both readers answer, and what is said has a place and a code.

use generator::codes::CODES;
use generator::config::{ListOptions, Unreadable};
use generator::diagnostics::Report;
use generator::pipeline::{Set, read_with};
use proptest::prelude::*;
use std::path::Path;

const IPC: &str = "lr_param.improved_position_control.";

/// One axis list at a cycle time of 1 ms.
fn read_list(text: impl AsRef<[u8]>) -> (Option<Set>, Report) {
    let options = ListOptions { cycle_time: Some("1ms".to_owned()), ..ListOptions::default() };
    read("x.lis", text.as_ref(), &options)
}

/// A set without files next to it.
fn read_set(text: impl AsRef<[u8]>) -> (Option<Set>, Report) {
    read("set.toml", text.as_ref(), &ListOptions::default())
}

fn read(name: &str, text: &[u8], options: &ListOptions) -> (Option<Set>, Report) {
    let load = |path: &Path| match path == Path::new(name) {
        true => Ok(text.to_vec()),
        false => Err(Unreadable::System("there is no such file".to_owned())),
    };
    let (set, report) = read_with(Path::new(name), options, &load);
    assert_eq!(set.is_none(), report.has_errors(), "{report}");
    (set, report)
}

/// Pieces without a blank.
const WORDS: &str = "stage[ stage[0]. filter[1]. filter. ] osc_damping mode fg_f0 order type enable getriebe[0].dynamik.vb_max \
    [[axis.X. DIRECT ALLPASS # ( \" ' . 0x 1 -1 1e9 nan 53 ä";
/// Pieces with one.
const SPACED: [&str; 10] = ["\n[axis.", "]]\n", "stage = [{ ", "filter = [{", " }]", "\n", " ", "\t", " = ", "\r\n"];

/// Pieces from which lists and sets are made, so that random files come past the first line.
fn pieces() -> impl Strategy<Value = Vec<u8>> {
    let piece = prop_oneof![
        Just(IPC.to_owned()),
        Just("cycle_time = \"1ms\"\n[axis.X]\n".to_owned()),
        prop::sample::select(WORDS.split(' ').chain(SPACED).collect::<Vec<_>>()).prop_map(str::to_owned),
        any::<u64>().prop_map(|n| n.to_string()),
        any::<f64>().prop_map(|x| x.to_string()),
    ];
    prop::collection::vec(piece, 0..60).prop_map(|pieces| pieces.concat().into_bytes())
}

/// A valid list and a valid set, which nothing is said about.
fn valid() -> [String; 2] {
    let filter = "filter.order 1|filter.fg_f0 53|filter.q_factor 10";
    let list = format!("v_add_max_fact 1000|stage[0].mode DIRECT|stage[0].{}", filter.replace('|', "|stage[0]."));
    let list: String = list.split('|').map(|line| format!("{IPC}{line}\n")).collect();
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
        // The lists that it names are not there: whatever else is wrong is said next to that.
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

proptest! {
    /// A file in which every byte is plain is split faster: to the same parts.
    #[test]
    fn what_stands_elsewhere_in_a_file_changes_no_line(bytes in prop::collection::vec(
        prop::sample::select(&b"\n\t a.b1#(/*;\""[..]), 0..200
    )) {
        // What kind of file it is, is told from all of it.
        let list = [b"kopf.achs_nr 1\n", &bytes[..]].concat();
        let other = [&list[..], b"\n#\xE4"].concat();
        prop_assert_eq!(read_list(&list).1, read_list(&other).1);
    }
}
