//! Bytes that neither a list nor TOML takes lightly.

use generator::config::ListOptions;
use generator::import_export;
use std::path::Path;

use super::{import, import_at, meaning, round_trip};

#[test]
fn quotes_backslashes_and_signs_in_comments() {
    for comment in [
        "\"\"\"",
        "\"\"\"\"\"\"",
        "\"",
        "'''",
        "\\",
        "\\\\",
        "\\n",
        "#",
        "# #",
        "(",
        "( ) (",
        "=",
        "[[x]]",
        "\t",
        " ",
        "\\u0041",
        "\u{1}\u{7f}\u{1b}[0m",
        "\u{e4}\u{20ac}\u{1f600}",
        "\u{feff}\u{202e}",
        "\u{85}\u{2028}",
        "a\rb",
    ] {
        for around in [["#", "\n"], ["(", "\r\n"], ["  # ", ""], ["kopf.achs_nr 1 # ", "\nx.y 1"], ["x.y 1 (", ""]] {
            round_trip(around.join(comment).as_bytes());
        }
    }
}

#[test]
fn the_set_shows_them_like_this() {
    let set = round_trip(b"# \"\"\" \\ \x01 \xE4 \x80 \t\nkopf.achs_nr  1 \t\r\nx.y \t z");
    let lines = set.split("imported_list]\n").nth(1).unwrap();
    assert_eq!(
        lines,
        "encoding = \"latin-1\" # a character is the byte of its number\n\
         lines = \"\"\"\n\
         # \\\"\\\"\" \\\\ \\u0001 \u{e4} \\u0080 \\t\n\
         kopf.achs_nr  = \\t\\r\n\
         x.y \t z\"\"\"\n"
    );
    assert!(set.contains("\n# \"\"\" \\ \u{fffd} \u{e4} \u{fffd}\n[axis.X]\nkopf.achs_nr = 1\n"), "{set}");
}

#[test]
fn nothing_and_nearly_nothing() {
    for list in
        ["", "\n", "\r\n", "\r", " ", "\u{feff}", "\u{feff}\n", "#", "kopf.achs_nr 1", "kopf.achs_nr 1\r", "\n\n\n"]
    {
        round_trip(list.as_bytes());
    }
}

#[test]
fn every_byte_in_a_comment() {
    let all: Vec<u8> = (0..=255).filter(|byte| *byte != b'\n').collect();
    round_trip(&[b"# ", &all[..], b"\nkopf.achs_nr 1 # ", &all[..], b"\n"].concat());
}

#[test]
fn bytes_above_7f_in_a_parameter_of_another_function() {
    let list = b"kopf.log_achs_name  Achse_f\xFCr_\xC4 # \xE4\nkopf.achs_nr 1\n";
    let list = [&list[..], &b"antr.text \xE4\n".repeat(50)].concat();
    round_trip(&list);
    let (_, report) = import(b"kopf.log_achs_name f\xFCr\n");
    assert_eq!(report.to_string(), "");
}

#[test]
fn long_lines() {
    let long = "x".repeat(1_000_000);
    round_trip(format!("# {long}\nkopf.achs_nr 1 # {long}\na.{long} {long}\n").as_bytes());
}

#[test]
fn both_generations_in_one_stage() {
    let ipc = format!("{}stage[1].", super::IPC);
    let list = format!(
        "{ipc}filter.order 1 # old\n{ipc}filter[1].order 2\n{ipc}filter[0].fg_f0 5 # new\n{ipc}filter.damping 1\n{ipc}mode 0\n"
    );
    let set = round_trip(list.as_bytes());
    assert_eq!(meaning("set.toml", set.as_bytes()), meaning("x.lis", list.as_bytes()));
    assert!(set.contains("stage.filter]]\norder = 1 # old\nfg_f0 = 5 # new\ndamping = 1\n"), "{set}");
}

#[test]
fn gear_steps_far_apart() {
    let list = "getriebe[3].dynamik.vb_max 5 # three\ngetriebe[].dynamik.vb_max 7\n";
    let set = round_trip(list.as_bytes());
    assert_eq!(meaning("set.toml", set.as_bytes()), meaning("x.lis", list.as_bytes()));
    round_trip(b"getriebe[15].dynamik.vb_max 5\n");
}

#[test]
fn a_list_that_cannot_be_read_is_not_imported() {
    let (set, report) = import("kopf.achs_nr x\nkopf.achs_nr 1\n");
    assert_eq!(set, None);
    assert_eq!(
        report.to_string(),
        "x.lis:1:14: error[AX201]: `kopf.achs_nr` (P-AXIS-00016) is `x`, no whole number\n    \
         allowed: a whole number, 0 <= achs_nr <= 65535\n\
         x.lis:2:1: error[AX107]: `kopf.achs_nr` is given twice, first in line 1\n    \
         write instead: one of the two lines\n"
    );
}

#[test]
fn without_a_cycle_time_the_reader_says_what_is_missing() {
    let set = import_at(None, "kopf.achs_nr 1\n").0.unwrap();
    assert_eq!(meaning("set.toml", set.as_bytes()).unwrap_err(), [("AX009", "the set has no cycle time".to_owned())]);
}

#[test]
fn a_cycle_time_or_a_name_that_is_none() {
    let (_, report) = import_at(Some("1"), "");
    assert_eq!(
        report.to_string(),
        "--cycle-time: error[AX205]: `--cycle-time` is `1`, which has no unit\n    \
         allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s\n    \
         write instead: \"1ms\", if milliseconds are meant\n"
    );
    let options = ListOptions { name: Some("1".to_owned()), ..ListOptions::default() };
    let (_, report) = import_export::import(Path::new("x.lis"), &options, &|_| Ok(Vec::new()));
    assert!(report.to_string().starts_with("--name: error[AX006]: `1` is not a name for an axis\n"), "{report}");
}
