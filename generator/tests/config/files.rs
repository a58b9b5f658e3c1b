//! Files, options, names; lists that a set names.

use super::{IPC, assert_said, direct, read, short};
use generator::axis::{Filter, Prototype};
use generator::config::{ListOptions, Unreadable};
use generator::pipeline::read_with;
use std::path::Path;

fn options(cycle_time: Option<&str>, name: Option<&str>) -> ListOptions {
    ListOptions { cycle_time: cycle_time.map(str::to_owned), name: name.map(str::to_owned), ..ListOptions::default() }
}

#[test]
fn a_file_that_is_too_large() {
    let (_, report) = read_with(Path::new("x.lis"), &options(Some("1ms"), None), &|_| Err(Unreadable::TooLarge));
    assert_said(
        &report.to_string(),
        &["x.lis: error[AX002]: `x.lis` is too large for a set or an axis list", "    allowed: 64 MiB"],
    );
}

#[test]
fn a_list_that_a_set_names_and_nobody_has() {
    let set = b"cycle_time = \"1ms\"\n[axis.X]\nlist = \"lists/x.lis\"\n[axis.Y]\nlist = \"\"";
    let (_, report) = read("sets/set.toml", &[("sets/set.toml", set)], &ListOptions::default());
    assert_said(
        &report.to_string(),
        &[
            "sets/set.toml:3:8: error[AX001]: `sets/lists/x.lis` cannot be read: there is no such file",
            "    allowed: a file that can be read; its path begins at the folder of the set",
            "sets/set.toml:5:8: error[AX001]: `sets/` cannot be read: there is no such file",
            "    allowed: a file that can be read; its path begins at the folder of the set",
        ],
    );
}

#[test]
fn messages_about_a_list_name_the_list_and_all_are_told() {
    let set = "cycle_time = \"1ms\"\ntarget = []\n[axis.X]\nlist = \"x.lis\"\ngear = 99\n[axis.Y]\nlist = \"y.lis\"\nreal = 1";
    let list = direct("ipc.enable MAYBE").replace("ipc.", IPC);
    let files =
        [("set.toml", set.as_bytes()), ("x.lis", list.as_bytes()), ("y.lis", b"?\nkenngr.swe_pos 1".as_slice())];
    let (_, report) = read("set.toml", &files, &ListOptions::default());
    assert_said(
        &short(&report),
        &[
            "set.toml:2:1: error[AX104]: `target` is not a key of a set",
            "    allowed: cycle_time, targets, axis.NAME",
            "    write instead: targets",
            "x.lis:1:43: error[AX202]: `ipc.enable` (P-AXIS-00758) is `MAYBE`",
            "    allowed: OFF (FALSE, 0), ON (TRUE, 1), DRYRUN",
            "set.toml:5:8: error[AX203]: `gear` is 99",
            "    allowed: 0 <= gear <= 15",
            "set.toml:8:8: error[AX202]: `real` is `1`",
            "    allowed: f64 (LREAL), f32 (REAL)",
            "y.lis:1:1: error[AX101]: `?` is not a path",
            "    allowed: path value # comment",
        ],
    );
}

#[test]
fn keys_of_a_set_override_its_list() {
    let set = format!(
        "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\n{IPC}v_add_max_fact = 7\n\
         {IPC}stage = [{{ filter = [{{ order = 3, prototype = \"BESSEL\" }}] }}]"
    );
    // Overridden, a value need not be within its range.
    let list = direct("ipc.v_add_max_fact 9999").replace("ipc.", IPC);
    let files = [("set.toml", set.as_bytes()), ("x.lis", list.as_bytes())];
    let (set, report) = read("set.toml", &files, &ListOptions::default());
    assert_eq!(report.to_string(), "");
    let axis = set.unwrap().axes.remove(0).axis;
    assert_eq!(axis.ipc.v_add_max_fact, 7);
    let filter = Filter::Bandpass { prototype: Prototype::Bessel, order: 3, f0: 53.0, q_factor: 10.0 };
    assert_eq!(axis.ipc.stage[0].as_ref().unwrap().filter[0], filter);
}

#[test]
fn a_list_needs_a_cycle_time() {
    let list = direct("").replace("ipc.", IPC);
    let said = |cycle_time| short(&read("x.lis", &[("x.lis", list.as_bytes())], &options(cycle_time, None)).1);
    assert_said(
        &said(None),
        &[
            "x.lis: error[AX009]: no axis list holds the cycle time of the position controller",
            "    write instead: --cycle-time 1ms, if that is its cycle",
        ],
    );
    assert_said(
        &said(Some("1")),
        &[
            "--cycle-time: error[AX205]: `--cycle-time` is `1`, which has no unit",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
            "    write instead: \"1ms\", if milliseconds are meant",
        ],
    );
    assert_said(
        &said(Some("5s")),
        &["--cycle-time: error[AX203]: `cycle_time` is 5s", "    allowed: 1ns <= cycle_time <= 4.294967295s"],
    );
}

#[test]
fn a_set_has_a_cycle_time_and_names_of_its_own() {
    let files = [("set.toml", b"cycle_time = \"1ms\"\n[axis.X]".as_slice())];
    let (_, report) = read("set.toml", &files, &options(Some("1ms"), Some("Y")));
    assert_said(
        &short(&report),
        &[
            "--cycle-time: error[AX008]: --cycle-time is for a single axis list; this is a set",
            "    write instead: the key `cycle_time` of the set",
            "--name: error[AX008]: --name is for a single axis list; this is a set",
            "    write instead: the name in [axis.NAME]",
            "set.toml:2:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
}

#[test]
fn names_of_lists() {
    let name = |path: &str, name| {
        let (set, report) = read(path, &[(path, b"kopf.achs_nr 1")], &options(Some("1ms"), name));
        set.map(|set| set.axes[0].axis.name.clone()).ok_or_else(|| report.diagnostics[0].to_string())
    };
    assert_eq!(name("lists/rack-and-pinion.lis", None).unwrap(), "rack_and_pinion");
    assert_eq!(name("X", None).unwrap(), "X");
    assert_eq!(name("1.txt", None).unwrap(), "axis_1");
    assert_eq!(name("1.txt", Some("Y2")).unwrap(), "Y2");
    assert_eq!(name("53 Hz, old.lis", None).unwrap(), "axis_53_Hz_old");
    assert_eq!(name("_x__y_.lis", None).unwrap(), "x_y");
    for allowed in ["X", "x1", "rack_and_pinion", "A2345678901234567890123456789012"] {
        assert_eq!(name("1.txt", Some(allowed)).unwrap(), allowed);
    }
    for no_name in ["", "_x", "x_", "x__y", "1x", "x-y", "x y", "\u{e4}", "A23456789012345678901234567890123"] {
        assert!(name("1.txt", Some(no_name)).is_err(), "{no_name}");
    }
    let allowed = "\n    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last \
                   (what C and ST both accept)";
    assert_eq!(
        name("\u{e4}.lis", None).unwrap_err(),
        format!("\u{e4}.lis: error[AX006]: `` is not a name for an axis{allowed}\n    write instead: --name NAME")
    );
    assert_eq!(
        name("x.lis", Some("x */")).unwrap_err(),
        format!("--name: error[AX006]: `x */` is not a name for an axis{allowed}")
    );
}

/// The signals of a measurement in XML have numbers: the default of what it is from would be a guess. Another XML is not
/// read, whatever is stated.
#[test]
fn a_response_without_names_says_what_it_is_from() {
    let list = direct("").replace("ipc.", IPC);
    let set =
        |key: &str| format!("cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\ndrive.response = \"p.xml\"\n{key}");
    let said = |set: &str, xml: &str| {
        let files = [("set.toml", set.as_bytes()), ("x.lis", list.as_bytes()), ("p.xml", xml.as_bytes())];
        read("set.toml", &files, &ListOptions::default()).1.to_string()
    };
    let stated = set("drive.response_from = \"v_cmd\"\n");
    let lists = ["m_listPrimaryFreqRespSigNodeData", "m_listPrimaryFreqRespSigNodeData"];
    let of_two = lists.map(|name| format!("<LinkedList name=\"{name}\"/>")).concat();
    let pairs =
        format!("<ResponseTestCustom><LinkedList name=\"{}\"><P/><P/></LinkedList></ResponseTestCustom>", lists[0]);
    for (set, xml, expected) in [
        (&set(""), &pairs, "p.xml: error[AX211]: XML, in which signals have numbers instead of names\n"),
        (&stated, &pairs, "p.xml:1:21: error[AX118]: 2 pairs of an input and an output\n"),
        (&set(""), &of_two, "p.xml:1:54: error[AX023]: the file is broken XML"),
        (&set(""), &"<Project/>".to_owned(), "p.xml:1:1: error[AX023]: XML with the element `Project`\n"),
    ] {
        let said = said(set, xml);
        assert!(said.contains(expected), "{said}");
    }
}
