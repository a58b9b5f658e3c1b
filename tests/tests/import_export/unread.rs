//! Values that nobody can read, of parameters that other functions have too: their lines are kept, as `check` passes over them.

use super::{export_beside, exported, import, imported, meaning};

const LIST: &str =
    "vorsteuer.velocity_delay_time  abc # why?\nantr.v_reso_num xyz\nantr.v_reso_denom 7\ngetriebe[0].load\n";

#[test]
fn they_are_kept_with_a_warning() {
    let (set, report) = import(LIST);
    let set = set.unwrap();
    assert_eq!(
        report.to_string(),
        "x.lis:4:17: warning[AX103]: `getriebe[0].load` (P-AXIS-00391) has no value\n    \
         allowed: 0 <= load <= 1.7976931348623157e308 [kg m^2, linear motor: kg]\n\
         x.lis:2:17: warning[AX201]: `antr.v_reso_num` (P-AXIS-00206) is `xyz`, no whole number\n    \
         allowed: a whole number, 0 <= v_reso_num <= 4294967295 [increments]\n\
         x.lis:1:32: warning[AX201]: `vorsteuer.velocity_delay_time` (P-AXIS-00389) is `abc`, no whole number\n    \
         allowed: a whole number, 0 <= velocity_delay_time <= 65535 [us]\n"
    );
    assert!(set.contains("\nantr.v_reso_denom = 7\n") && !set.contains("v_reso_num ="), "{set}");
    assert_eq!(String::from_utf8(exported(&set)).unwrap(), LIST);
}

#[test]
fn a_set_that_names_the_list_is_exported_with_its_lines() {
    let (list, report) =
        export_beside("[axis.X]\nlist = 'x.lis'\nantr.v_reso_denom = 8\n", &[("x.lis", LIST.as_bytes())]);
    assert_eq!(String::from_utf8(list.unwrap()).unwrap(), LIST.replace("denom 7", "denom 8"));
    assert_eq!(report.warnings(), 3, "{report}");
}

#[test]
fn a_sign_that_stands_for_a_value_is_none() {
    let (set, report) = import("antr.v_reso_num =7\n");
    assert!(set.is_none());
    assert_eq!(report.diagnostics[0].code, "AX101");
    assert!(imported("vorsteuer.shift_time 2\n").contains("shift_time = 2"));
}

/// The set would mean something else: nothing is imported, as nothing is checked.
#[test]
fn a_value_that_the_axis_uses_is_an_error() {
    for (line, code) in [("vorsteuer.vorsteuerung VELL", "AX202"), ("getriebe[0].kv fast", "AX201")] {
        let list = format!("{line}\n");
        let (set, report) = import(&list);
        assert!(set.is_none(), "{line}");
        assert_eq!(report.diagnostics.iter().map(|said| said.code).collect::<Vec<_>>(), [code], "{report}");
        let found = meaning("x.lis", list.as_bytes()).unwrap_err();
        assert!(found.iter().any(|(said, _)| *said == code), "{found:?}");
    }
    // Another gear step than the one that is used.
    assert!(import("getriebe[0].kv 2000\ngetriebe[1].kv fast\n").0.is_some());
}
