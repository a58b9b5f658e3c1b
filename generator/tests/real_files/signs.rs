//! The vendor's signs: comments, strings, text after a value, words of other files.

use super::{IPC, VALID, canonical, read, round_trip};

/// What is said of a valid list whose line of the frequency is another.
fn said(line: &str) -> String {
    let usual = format!("{IPC}stage[0].filter.fg_f0      53");
    let list = VALID.replace(&usual, line);
    assert_ne!(list, VALID, "the line is there");
    let (_, report) = read(&[("x.lis", list.as_bytes())]);
    report.to_string().replace(IPC, "ipc.").trim_end().to_owned()
}

#[test]
fn every_sign_begins_a_comment() {
    for sign in ["#", "(", "/*", ";", "//"] {
        for comment in
            [format!(" {sign} Hz"), format!("{sign}Hz (a) \"b"), format!("{sign}\u{e4}"), format!("\t{sign}")]
        {
            assert_eq!(said(&format!("{IPC}stage[0].filter.fg_f0 53{comment}")), "", "{comment}");
            assert_eq!(said(&format!("{comment}\n{IPC}stage[0].filter.fg_f0 53")), "", "{comment}");
        }
        let list =
            VALID.replace("DIRECT", &format!("DIRECT{sign} c")).replace("kopf", &format!("{sign} d \u{e4}\nkopf"));
        round_trip(("x.lis", list.as_bytes()));
    }
}

#[test]
fn a_string_in_quotes_may_hold_signs_of_comments() {
    let list = format!("kopf.log_achs_name \"X (1) # a;b /* c // d\" # \u{e4}\nantr.text \"f\u{fc}r\"\n{VALID}");
    let list = list.replace("DRYRUN", "\"DRYRUN\" # c").replace(" 530000", " \"530000\"");
    assert_eq!(canonical(("x.lis", list.as_bytes())), canonical(("x.lis", VALID.as_bytes())));
    let set = round_trip(("x.lis", list.as_bytes()));
    assert!(set.contains("enable = \"DRYRUN\" # c\n"), "{set}");
    let changed = set.replace("enable = \"DRYRUN\"", "enable = \"OFF\"");
    let list = String::from_utf8(super::exported(&[("set.toml", changed.as_bytes())])).unwrap();
    assert!(list.contains("enable                     \"OFF\" # c\n"), "{list}");
}

#[test]
fn text_behind_a_value() {
    assert_eq!(
        said(&format!("{IPC}stage[0].filter.fg_f0 53 Hz, measured")),
        "x.lis:8:53: warning[AX111]: a controller takes `Hz, measured` for a comment: the value is `53` [Hz]\n    \
         write instead: ipc.stage[0].filter.fg_f0 53 # Hz, measured"
            .replace("8:53", &format!("8:{}", IPC.len() + "stage[0].filter.fg_f0 53 ".len() + 1))
    );
    let list = VALID.replace(" 53\n", " 53 Hz # c\n").replace("DRYRUN", "DRYRUN for now");
    let set = round_trip(("x.lis", list.as_bytes()));
    assert!(set.contains("# for now") && set.contains("# Hz # c"), "{set}");
    // Without the value its text goes, too: it would be a parameter.
    let without = set.lines().filter(|line| !line.contains("enable = ")).collect::<Vec<_>>().join("\n");
    let list = String::from_utf8(super::exported(&[("set.toml", without.as_bytes())])).unwrap();
    assert!(!list.contains("for now"), "{list}");
}

#[test]
fn a_second_value_is_no_comment() {
    for (value, instead) in [("53 000", None), ("53 ,5", Some("53.5")), ("5 3", None), ("53 54", None)] {
        let said = said(&format!("{IPC}stage[0].filter.fg_f0 {value}"));
        let expected = instead.map(|instead| format!("write instead: {instead}"));
        assert!(said.contains("error[AX101]"), "{said}");
        assert_eq!(said.lines().nth(2).map(str::trim), expected.as_deref());
    }
    let mode = VALID.replace("DIRECT\n", "DIRECT INDIRECT\n");
    assert!(read(&[("x.lis", mode.as_bytes())]).1.to_string().contains("error[AX101]"));
}

#[test]
fn words_with_text_behind_them() {
    let said = |value: &str| {
        let list = format!(
            "vorsteuer.vorsteuerung {value}\ngetriebe[0].kv 1000\ngetriebe[0].multi_gain_z 1\ngetriebe[0].multi_gain_n 1\n"
        );
        let (set, report) = read(&[("x.lis", list.as_bytes())]);
        (set.map(|set| set.axes[0].axis.canonical.contains("VEL")), report.to_string())
    };
    assert_eq!(said("VEL"), (Some(true), String::new()));
    let (set, text) = said("VEL velocity of the axis");
    assert!(set == Some(true) && text.contains("warning[AX111]: a controller takes `velocity of the axis`"), "{text}");
    let (set, text) = said("VEL ACCC");
    assert!(set.is_none() && text.contains("error[AX202]"), "{text}");
    let (set, text) = said("VEL | x");
    assert!(set.is_none() && text.contains("error[AX202]"), "{text}");
    let (set, text) = said("0x1 velocity");
    assert!(set == Some(true) && text.contains("warning[AX111]"), "{text}");
}

#[test]
fn a_comment_ends_with_its_line() {
    assert_eq!(
        said(&format!("/* Hz */ {IPC}stage[0].filter.fg_f0 53")).lines().next().unwrap(),
        "x.lis:8:10: error[AX113]: text after `*/`: a comment ends with its line, and the controller does not read the text"
    );
    assert_eq!(said(&format!("{IPC}stage[0].filter.fg_f0 53 /* Hz */ # measured")), "");
}

#[test]
fn a_comment_over_several_lines_as_a_manual_prints_it() {
    assert_eq!(
        said(&format!(
            "{IPC}stage[0].filter.fg_f0 53 # the vibration\n              of the bridge, 1.5 m\n              above it"
        )),
        "x.lis:9:15: warning[AX112]: the line continues the comment above, and has no sign of a comment\n    \
         write instead: # of the bridge, 1.5 m"
    );
    // A line that may be a parameter is none of it.
    for line in ["  antr.x 1", "  stage[0].x 1", "  1200000", "  a = 1"] {
        let said = said(&format!("{IPC}stage[0].filter.fg_f0 53 # c\n{line}"));
        assert!(!said.contains("AX112"), "{said}");
    }
}

#[test]
fn a_value_below_its_path() {
    assert_eq!(
        said("lr param.improved position control.stage[0].filter.fg f0\n                  53"),
        "x.lis:8:1: error[AX103]: `ipc.stage[0].filter.fg_f0` has no value: it stands alone in the next line\n    \
         allowed: path and value in one line\n    write instead: ipc.stage[0].filter.fg_f0 53"
    );
}

#[test]
fn words_of_an_nc_program() {
    for (word, input) in [
        ("G135", "feedforward_active"),
        ("G137", "feedforward_active"),
        ("G136=80", "feedforward_percentage"),
        ("S[G136=80]", "feedforward_percentage"),
        ("S2[G135", "feedforward_active"),
    ] {
        let (_, report) = read(&[("x.lis", format!("{VALID}{word} X80\n").as_bytes())]);
        let said = report.to_string();
        assert!(said.contains("error[AX115]") && said.contains(&format!("the input `{input}`")), "{said}");
    }
}
