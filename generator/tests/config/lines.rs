//! How a line of a list is split: seen at what is read from it, and at the places of messages.

use super::{IPC, read_list, said, said_of_axis};

#[test]
fn statements_and_comments() {
    for line in [
        "kopf.achs_nr 3",
        " \tkopf.achs_nr\t 3 \t\r\n",
        "kopf.achs_nr 3#c",
        "kopf.achs_nr\t3\t( P-AXIS-00016 : x",
        "kopf.achs_nr 3(c",
        "kopf.achs_nr 3;c",
        "kopf.achs_nr 3 /* c",
        "kopf.achs_nr 3//c",
        "kopf.achs_nr \"3\"",
    ] {
        let (set, report) = read_list(line);
        assert_eq!(set.unwrap_or_else(|| panic!("{report}")).axes[0].axis.control.number, 3, "{line:?}");
    }
    for comment in [
        "",
        "  ",
        "\r\n",
        "# kopf.achs_nr 1",
        "(kopf.achs_nr 1",
        "  ( a",
        "#\u{e4}",
        "/* kopf.achs_nr 1 */",
        "// kopf.achs_nr 1",
        "; kopf.achs_nr 1",
    ] {
        let (set, _) = read_list(format!("{comment}\nkopf.achs_nr 3"));
        assert_eq!(set.unwrap().axes[0].axis.control.number, 3, "{comment:?}");
    }
}

#[test]
fn bytes_that_only_a_comment_may_have() {
    let bad = |line: &[u8]| {
        let (_, report) = read_list([line, b"\nkopf.achs_nr 1"].concat());
        report.diagnostics.iter().find(|said| said.code == "AX102").map(|said| said.place.column)
    };
    assert_eq!(bad(b"kopf.achs_nr \xE4"), Some(14));
    assert_eq!(bad(b"a\0 1"), Some(2));
    assert_eq!(bad(b"a 1\r#"), Some(4));
    assert_eq!(bad(b"a\0 1\r#"), Some(2));
    assert_eq!(bad(b"a\"\r\" \xE4"), Some(3));
    assert_eq!(bad(b"a(\r# \xE4"), None);
    assert_eq!(bad(b"a(b)( # \xE4"), None);
    assert_eq!(bad(b"a 1 # \xE4\0"), None);
    assert_eq!(bad(b"a 1 (\xB0"), None);
}

#[test]
fn malformed_paths() {
    for malformed in [".", "a.", ".a", "a..b", "a[", "a[x]", "a[1", "[1]", "a[0][", "1a", "a=1", "a-b", "a[[0]]"] {
        assert!(said(&format!("{malformed} 1\nkopf.achs_nr 1")).contains("AX101"), "{malformed}");
    }
    assert!(!said(&format!("{} 1\nkopf.achs_nr 1", "x".repeat(1000))).contains("error"));
}

#[test]
fn indices_are_numbers() {
    for index in ["1", "01", "0001"] {
        let (set, report) = read_list(format!(
            "{IPC}stage[{index}].mode DIRECT\n{IPC}stage[1].filter.fg_f0 60\n{IPC}stage[1].filter.q_factor 2\n{IPC}stage[1].filter.order 1"
        ));
        assert!(set.is_some(), "{report}");
    }
    for index in ["16", "99999999999"] {
        assert!(said(&format!("getriebe[{index}].dynamik.vb_max 1")).contains("AX106"), "{index}");
    }
}

#[test]
fn lines_and_columns_count_characters_from_one() {
    assert!(said("kopf.achs_nr 1\n?").starts_with("x.lis:2:1: "));
    let wide = "\u{e4}".repeat(5000);
    let said = said_of_axis(&format!("kopf = {{ '{wide}' = 1, b = 2 }}"));
    assert!(said.contains("set.toml:3:10: ") && said.contains("set.toml:3:5018: "), "{said}");
}
