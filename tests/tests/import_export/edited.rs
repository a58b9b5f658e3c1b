//! Sets that were changed after their import.

use super::{IPC, export_beside, exported_text, imported, round_trip};

const LIST: &str = "\
( the machine
kopf.achs_nr\t0X7\t# \t the number
foreign.thing  x y z   # \\ \"\"\" '

ipc.stage[1].mode   direct    # 53 Hz
 ipc.stage[].filter.order 1
ipc.stage[1]osc_damping .5(no comment
ipc.enable  FALSE# off
";

fn list() -> String {
    LIST.replace("ipc.", IPC).replace(".5(no comment", ".5 (a comment")
}

#[test]
fn an_edited_value_changes_its_text_and_nothing_else() {
    let set = round_trip(list().as_bytes());
    for (from, to, line, instead) in [
        ("achs_nr = 7", "achs_nr = 8", "0X7\t# \t", "8\t# \t"),
        ("achs_nr = 7", "achs_nr = 0x7", "", ""),
        ("mode = \"direct\"", "mode = \"INDIRECT\"", " direct ", " INDIRECT "),
        ("mode = \"direct\"", "mode = 1", " direct ", " 1 "),
        ("order = 1", "order = 3", "order 1", "order 3"),
        ("osc_damping = 0.5", "osc_damping = 0.25", " .5 (", " 0.25 ("),
        ("enable = \"FALSE\"", "enable = true", "FALSE#", "TRUE#"),
    ] {
        assert!(set.contains(from), "{from}\n{set}");
        assert_eq!(exported_text(&set.replacen(from, to, 1)), list().replacen(line, instead, 1), "{to}");
    }
}

#[test]
fn a_value_that_was_taken_out_takes_its_line_along_but_not_the_comment() {
    let set = imported(list());
    let without = |line: &str| {
        assert!(set.contains(line), "{line}\n{set}");
        exported_text(&set.replacen(line, "", 1))
    };
    assert_eq!(without("filter.order = 1"), list().replace(&format!(" {IPC}stage[].filter.order 1\n"), ""));
    assert_eq!(without("enable = \"FALSE\" # off\n"), list().replace(&format!("{IPC}enable  FALSE# off"), "# off"));
    assert_eq!(without("kopf.achs_nr = 7"), list().replace("kopf.achs_nr\t0X7\t", ""));
}

#[test]
fn new_parameters_stand_at_the_end() {
    let set = imported(list().trim_end())
        .replace("kopf.achs_nr = 7", "kopf.achs_nr = 7\nkenngr.gantry_ax_nr = 1\nreal = 'f32'");
    let new = "\n# Not in the list so far:\nkenngr.gantry_ax_nr 1\n# axgen: real f32\n";
    assert_eq!(exported_text(&set), list().trim_end().to_owned() + new);
    let windows = imported(list().replace('\n', "\r\n")).replace("kopf.achs_nr = 7", "gear = 3\nkopf.achs_nr = 7");
    let new = "# Not in the list so far:\r\n# axgen: gear 3\r\n";
    assert_eq!(exported_text(&windows), list().replace('\n', "\r\n") + new);
}

#[test]
fn keys_of_our_own_come_back_from_their_comments() {
    let list = list() + "# axgen: gear 99\n #axgen:\tfade 0.2s \n# axgen: drive.response \"a\" b\n";
    let set = round_trip(list.as_bytes());
    assert!(set.contains("\ngear = 99\nfade = \"0.2s\"\n"), "{set}");
    assert_eq!(exported_text(&set.replace("= \"0.2s\"", "= \"1s\"")), list.replace("fade 0.2s", "fade 1s"));
    assert_eq!(exported_text(&set.replace("fade = \"0.2s\"\n", "")), list.replace(" #axgen:\tfade 0.2s \n", ""));
}

#[test]
fn texts_and_lists_of_words_come_back_whole() {
    let keys = "process_data.objects = ['S-0-0036', 'S-0-0040']\ndrive_settings = []\n";
    for text in ["my resp.csv", "r\u{e9}ponse.csv", " # =\\ ", "\"a\" and \"b\"", "=", "", "0x1"] {
        let list = exported_text(&format!("[axis.X]\n{keys}drive.response = {text:?}\n"));
        let set = round_trip(list.as_bytes());
        let (tables, _) = set.split_once("\n# The list, line by line").expect("the lines");
        let again = exported_text(tables);
        assert!(list.lines().count() == 3 && list.lines().all(|line| again.contains(line)), "{list}\n{again}");
    }
}

#[test]
fn lines_that_were_edited_are_judged_as_a_list_is() {
    let set = imported("kopf.achs_nr 1\nforeign.x 1\n");
    let twice = set.replace("foreign.x 1", "kopf.achs_nr =\nkenngr..x 1");
    assert_eq!(
        export_beside(&twice, &[]).1.to_string(),
        "the exported list:2:1: error[AX107]: `kopf.achs_nr` is given twice, first in line 1\n    \
         write instead: one of the two lines\n\
         the exported list:3:1: error[AX101]: `kenngr..x` is not a path\n    allowed: path value # comment\n"
    );
    let alone = set.replace("foreign.x 1", "kenngr.gantry_ax_nr 1");
    let (list, report) = export_beside(&alone, &[]);
    assert_eq!(list.unwrap(), b"kopf.achs_nr 1\nkenngr.gantry_ax_nr 1\n");
    assert_eq!(
        report.to_string(),
        "set.toml:11:9: warning[AX105]: `kenngr.gantry_ax_nr` stands in the imported lines only: the axis does not have it\n    \
         write instead: the value below the axis, or import the list again\n"
    );
    let latin_1 = imported(b"kopf.achs_nr 1 # \xE4\n").replace("= # \u{e4}", "= # \u{20ac}");
    assert_eq!(
        export_beside(&latin_1, &[]).1.to_string(),
        "set.toml:12:9: error[AX102]: the lines have the character '\u{20ac}', which is none of latin-1\n    \
         allowed: characters up to U+00FF, or another encoding\n"
    );
}

#[test]
fn a_set_that_an_editor_saved_with_other_line_ends() {
    for list in [list(), list().replace('\n', "\r\n")] {
        let set = imported(&list);
        assert_eq!(exported_text(&set.replace('\n', "\r\n")), list);
    }
}

#[test]
fn an_axis_that_the_set_does_not_have() {
    assert_eq!(
        export_beside("[axis.X]\n[axis.Y]\n", &[]).1.to_string(),
        "set.toml: error[AX005]: the set has several axes\n    allowed: --axis with one of X, Y\n"
    );
}
