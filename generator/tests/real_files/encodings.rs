//! Lists in UTF-16, UTF-8 and Latin-1: the same meaning, the same places, the same bytes back.

use super::{VALID, canonical, exported, read, round_trip};

/// With its mark.
fn utf_16(text: &str, unit: fn(u16) -> [u8; 2]) -> Vec<u8> {
    "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(unit).collect()
}

fn encodings(text: &str) -> Vec<Vec<u8>> {
    vec![
        utf_16(text, u16::to_le_bytes),
        utf_16(text, u16::to_be_bytes),
        text.as_bytes().to_vec(),
        format!("\u{feff}{text}").into_bytes(),
        text.chars().map(|letter| u8::try_from(letter).unwrap_or(b'?')).collect(),
    ]
}

#[test]
fn all_mean_the_same_and_come_back_to_the_byte() {
    for ends in ["\n", "\r\n"] {
        let list =
            format!("# L\u{e4}ngsachse, 45\u{b0}\nkopf.log_achs_name L\u{e4}ngs\n{VALID}# \u{fc}").replace('\n', ends);
        for bytes in encodings(&list) {
            assert_eq!(canonical(("x.lis", &bytes)), canonical(("x.lis", VALID.as_bytes())));
            round_trip(("x.lis", &bytes));
        }
    }
    let wide = format!("# \u{20ac} \u{1f600}\n{VALID}");
    round_trip(("x.lis", &utf_16(&wide, u16::to_le_bytes)));
}

#[test]
fn a_change_keeps_the_encoding() {
    let list = format!("# L\u{e4}ngsachse\n{VALID}");
    for (bytes, changed) in encodings(&list).into_iter().zip(encodings(&list.replace("DRYRUN", "OFF"))) {
        let set = round_trip(("x.lis", &bytes)).replace("\"DRYRUN\"", "\"OFF\"");
        assert_eq!(exported(&[("set.toml", set.as_bytes())]), changed);
        let beside =
            "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\nlr_param.improved_position_control.enable = \"OFF\"\n";
        assert_eq!(exported(&[("set.toml", beside.as_bytes()), ("x.lis", &bytes)]), changed);
    }
}

#[test]
fn places_count_characters() {
    let list = format!("{VALID}# \u{e4}\nkopf.achs_nr 1 # \u{e4}\n");
    for bytes in encodings(&list) {
        let said = read(&[("x.lis", &bytes)]).1.to_string();
        assert!(
            said.starts_with("x.lis:13:1: error[AX107]: `kopf.achs_nr` is given twice, first in line 1\n"),
            "{said}"
        );
    }
}

#[test]
fn what_is_no_utf_16_is_said_to_be_none() {
    let mut odd = utf_16(VALID, u16::to_le_bytes);
    odd.push(0);
    let half = [utf_16(VALID, u16::to_le_bytes), vec![0x00, 0xD8]].concat();
    let without: Vec<u8> = VALID.encode_utf16().flat_map(u16::to_le_bytes).collect();
    for bytes in [odd, half, without] {
        let (set, report) = read(&[("x.lis", &bytes)]);
        assert!(set.is_none() && report.to_string().contains("UTF-16"), "{report}");
        assert_eq!(report.diagnostics.len(), 1, "{report}");
    }
}
