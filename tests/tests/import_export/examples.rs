//! The lists of the examples, and the set that comes of one.

use super::{IPC, export_beside, exported_text, import, import_at, meaning, round_trip};
use std::fs;
use std::path::PathBuf;

fn example(name: &str) -> Vec<u8> {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples"));
    fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn both_lists_come_back_to_the_byte_and_mean_the_same() {
    for name in ["rack-and-pinion.lis", "two-frequencies.lis"] {
        let list = example(name);
        let set = round_trip(&list);
        assert_eq!(meaning("set.toml", set.as_bytes()), meaning("x.lis", &list), "{name}");
        assert!(meaning("x.lis", &list).is_ok());
    }
}

#[test]
fn the_set_of_a_list() {
    let list = include_str!("imported.lis").replace("ipc.", IPC);
    assert_eq!(round_trip(list.as_bytes()), include_str!("imported.toml").replace("ipc.", IPC));
}

#[test]
fn an_axis_with_a_list_gives_the_list_with_what_overrides_it() {
    let list = example("rack-and-pinion.lis");
    let files = [("x.lis", &list[..])];
    let (same, report) = export_beside("cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\n", &files);
    assert_eq!((same.as_ref(), report.to_string().as_str()), (Some(&list), ""));
    let set = "[axis.X]\nlist = \"x.lis\"\nkopf.achs_nr = 7\nkenngr.gantry_ax_nr = 3\nfade = \"200ms\"\n";
    let (other, report) = export_beside(set, &files);
    let text = String::from_utf8(list).unwrap();
    let expected = text.replace("1\nkenngr", "7\nkenngr")
        + "# Not in the list so far:\nkenngr.gantry_ax_nr 3\n# axgen: fade 200ms\n";
    assert_eq!(String::from_utf8(other.unwrap()).unwrap(), expected);
    assert_eq!(
        report.to_string(),
        "set.toml:5:1: warning[AX109]: `fade` is a key of an axis set: no controller knows it, and it stands in a comment\n"
    );
}

#[test]
fn a_set_that_was_never_imported() {
    let set = "\
cycle_time = '62.5 us'
[axis.Y]
fade = '0.2s'
kopf.achs_nr = 2 # the number
getriebe = [{ dynamik.vb_max = 400_000 }]
[axis.Y.lr_param.improved_position_control]
enable = true
[[axis.Y.lr_param.improved_position_control.stage]]
mode = 1
direct_source = 'v_direct'
filter.fg_f0 = 36.0
filter.q_factor = 4
filter.order = 0b10
[[axis.Y.lr_param.improved_position_control.stage]]
filter = [{}, { fg_f0 = 1e1 }]
";
    let (list, report) = export_beside(set, &[]);
    let list = String::from_utf8(list.unwrap()).unwrap();
    let expected = "\
# axgen: cycle_time 62.5us
# axgen: fade 0.2s
kopf.achs_nr 2
getriebe[0].dynamik.vb_max 400000
ipc.enable TRUE
ipc.stage[0].mode 1
# axgen: ipc.stage[0].direct_source v_direct
ipc.stage[0].filter.fg_f0 36.0
ipc.stage[0].filter.q_factor 4
ipc.stage[0].filter.order 2
ipc.stage[1].filter[1].fg_f0 1e1
";
    assert_eq!(list.replace(IPC, "ipc."), expected);
    assert_eq!(report.warnings(), 3);
    // What the comments hold comes back with the list.
    for list in [&list, &list.replace("62.5us", "\"62.5us\"")] {
        let again = import_at(None, list).0.unwrap();
        assert!(again.contains("\ncycle_time = \"62.5us\"\n"), "{again}");
        assert!(again.contains("\nfade = \"0.2s\"\n") && again.contains("\ndirect_source = \"v_direct\"\n"), "{again}");
        assert_eq!(exported_text(&again), *list);
    }
    // Filters for another cycle would have other frequencies.
    assert!(import(&list).1.to_string().contains("error[AX121]"));
}
