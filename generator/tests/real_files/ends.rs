//! Lists that end with `Ende`: what is new goes before it, and nothing of ours may stand after it.

use super::{IPC, VALID, exported, read, round_trip};

#[test]
fn such_a_list_comes_back_to_the_byte() {
    for end in ["Ende", "Ende\n", "ENDE # the end\n", "  ende\r\n\r\n# behind\n", "Ende\nEnde\nx.y 1\n"] {
        round_trip(("x.lis", format!("{VALID}{end}").as_bytes()));
    }
}

#[test]
fn new_lines_of_an_export_stand_before_it() {
    let set = round_trip(("x.lis", format!("{VALID}#\nEnde\n# behind\n").as_bytes()));
    let more = set.replace("kopf.achs_nr = 1", "kopf.achs_nr = 1\ngetriebe = [{ kv = 2000 }]");
    let more = if more.contains("[[axis.X.getriebe]]") {
        more
    } else {
        set.replace("dynamik.vb_max = 530000", "dynamik.vb_max = 530000, kv = 2000")
    };
    let list = String::from_utf8(exported(&[("set.toml", more.as_bytes())])).unwrap();
    assert_eq!(list, format!("{VALID}#\n# Not in the list so far:\ngetriebe[0].kv 2000\nEnde\n# behind\n"));
    let beside = "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\ngetriebe = [{ kv = 7 }]\n";
    let list = format!("{VALID}Ende");
    let list = exported(&[("set.toml", beside.as_bytes()), ("x.lis", list.as_bytes())]);
    assert_eq!(String::from_utf8(list).unwrap(), format!("{VALID}# Not in the list so far:\ngetriebe[0].kv 7\nEnde"));
}

#[test]
fn a_parameter_behind_it_is_an_error() {
    let list = format!("{VALID}Ende\nkenngr.swe_pos 1\n{IPC}fade 1\ngetriebe[0].kv 1\n");
    let (_, report) = read(&[("x.lis", list.as_bytes())]);
    assert_eq!(
        report.to_string(),
        "x.lis:15:1: error[AX114]: `getriebe[0].kv` comes after `Ende`, where the list ends\n    \
         write instead: the line before `Ende`\n"
    );
}
