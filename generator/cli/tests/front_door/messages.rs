//! What ends a command, each with its code: for people with place, line and mark, for machines an object a line, and
//! nothing else on standard error.

use super::killed::content;
use super::{axgen, edit, started};
use serde_json::Value;
use std::process::{Command, Output};
use std::{fs, path::Path};

/// A folder with a set of one axis, one of two, a stimulus that is wrong twice, and what was generated and edited by hand.
fn folder() -> tempfile::TempDir {
    let folder = started();
    let path = folder.path();
    let one = fs::read_to_string(path.join("axes.toml")).unwrap();
    let other = one[one.find("[axis.X]").unwrap()..].replace("axis.X", "axis.Y");
    fs::write(path.join("two.toml"), one + &other).unwrap();
    fs::write(path.join("in.csv"), "v_motor,mode\n1.0,1\n1.0\n1.0,\u{202e}x\n").unwrap();
    fs::write(path.join("x.lis"), "kopf.achs_nr 1\n").unwrap();
    fs::write(path.join("columns.csv"), "v_motor,speed,v_motor\n").unwrap();
    let set = fs::read_to_string(path.join("axes.toml")).unwrap();
    fs::write(path.join("wrong.toml"), set.replace("fg_f0 = 53.0", "fg_f0 = 460.0")).unwrap();
    assert_eq!(axgen(path, &["generate", "axes.toml", "--target", "c"]).0, 0);
    for (name, text) in [("axis_x_ipc.c", "edited"), ("axis_x_ipc.h", "removed ")] {
        let file = path.join("generated").join(name);
        let new =
            fs::read_to_string(&file).unwrap().replace(if text == "edited" { "int32" } else { " checksum " }, text);
        fs::write(&file, new).unwrap();
    }
    edit(path, "fg_f0 = 53.0", "fg_f0 = 54.0");
    folder
}

/// What ends a command, in `ends.txt`: to people and to machines; nothing of the folder changes.
#[test]
fn whatever_ends_a_command_is_said_to_people_and_to_machines() {
    let folder = folder();
    let all = || [content(folder.path()), content(&folder.path().join("generated"))];
    let before = all();
    transcript::compare(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/front_door/ends.txt"), |_, arguments| {
        let words: Vec<&str> = arguments.split(' ').collect();
        let (code, out, human) = axgen(folder.path(), &words);
        assert_eq!(out, "", "{arguments}");
        let (ended, _, err) = axgen(folder.path(), &[&words[..], &["--message-format", "json"]].concat());
        assert_eq!(ended, code, "{arguments}");
        let said: Vec<Value> = err.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        let heads: Vec<&str> = human.lines().filter(|line| line.contains(": error[")).collect();
        assert_eq!(said.len(), heads.len(), "{err}");
        for (object, head) in said.iter().zip(heads) {
            assert_eq!(object["severity"], "error");
            let text = |key: &str| object[key].as_str().unwrap().to_owned();
            assert!(head.starts_with(&text("file")), "{object}");
            assert!(head.ends_with(&format!(": error[{}]: {}", text("code"), text("found"))), "{object}");
        }
        assert_eq!(all(), before, "{arguments}");
        format!("exit {code}\n{human}")
    });
}

/// What clap says to people it says with colours, and in its own form.
#[test]
fn a_wrong_command_line_is_an_object_too() {
    let folder = started();
    for (arguments, found) in [
        ("generate", "the following required arguments were not provided: <SET>"),
        ("check axes.toml --speed", "unexpected argument '--speed' found"),
        (
            "verify axes.toml --samples 0",
            "invalid value '0' for '--samples <N>': a whole number from 1 to 10000000 is allowed",
        ),
    ] {
        for json in [["--message-format=json"].as_slice(), &["--message-format", "json"]] {
            let words: Vec<&str> = arguments.split(' ').chain(json.iter().copied()).collect();
            let (code, out, err) = axgen(folder.path(), &words);
            assert_eq!((code, out.as_str(), err.lines().count()), (2, "", 1), "{err}");
            let object: Value = serde_json::from_str(&err).unwrap();
            assert_eq!((&object["code"], &object["file"]), (&"AX011".into(), &"axgen".into()));
            assert!(object["found"].as_str().unwrap().starts_with(found), "{err}");
        }
        let (code, _, err) = axgen(folder.path(), &arguments.split(' ').collect::<Vec<_>>());
        assert_eq!(code, 2);
        assert!(err.starts_with("error: ") && err.contains("try '--help'"), "{err}");
    }
}

/// The line is shown as a message shows a value: nothing of it steers a terminal or turns the order of the letters, and the
/// mark stands below the place all the same.
#[test]
fn the_line_that_is_shown_is_written_out() {
    let folder = tempfile::tempdir().unwrap();
    let line = "kenngr = { \"\u{202e}\" = 1,\tgantry_ax_nr = 70000 } # \u{2028}\u{2066}\u{200f}\u{e4} \\\"'";
    let shown = "kenngr = { \"\\u{202e}\" = 1, gantry_ax_nr = 70000 } # \\u{2028}\\u{2066}\\u{200f}\u{e4} \\\"'";
    fs::write(folder.path().join("set.toml"), format!("cycle_time = \"1ms\"\n[axis.X]\n{line}\n")).unwrap();
    let (code, _, err) = axgen(folder.path(), &["check", "set.toml"]);
    assert_eq!(code, 2);
    assert_eq!(
        err,
        format!(
            "set.toml:3:12: error[AX104]: `kenngr.\\u{{202e}}` is not known\n  3 | {shown}\n    |            ^\n\
             set.toml:3:36: error[AX203]: `kenngr.gantry_ax_nr` (P-AXIS-00070) is 70000\n  3 | {shown}\n    \
             |                                           ^\n    \
             allowed: 0 <= gantry_ax_nr <= 65535\n2 errors; nothing was written\n"
        )
    );
    let (_, _, err) = axgen(folder.path(), &["check", "set.toml", "--message-format", "json"]);
    assert!(!err.contains(['\u{202e}', '\u{2028}', '\u{2066}', '\u{200f}']), "{err}");
    let object: Value = serde_json::from_str(err.lines().last().unwrap()).unwrap();
    assert_eq!((&object["text"], &object["column"]), (&shown.into(), &36.into()));
}

/// Some editors put a mark before a text: it is not a character of the first line.
#[test]
fn a_byte_order_mark_moves_no_column() {
    let folder = tempfile::tempdir().unwrap();
    let said = |name: &str, text: &str, more: &[&str]| {
        fs::write(folder.path().join(name), text).unwrap();
        axgen(folder.path(), &[&["check", name], more].concat()).2
    };
    let list = "lr_param.improved_position_control.enable  5\nkenngr.gantry_ax_nr x\n";
    let set = "cycle_time = \"1 m\"\n[axis.X]\nkenngr.gantry_ax_nr = 70000\n";
    for (name, text, place) in [("x.lis", list, "x.lis:1:44: "), ("set.toml", set, "set.toml:1:14: ")] {
        for format in ["human", "json"] {
            let options: &[&str] = if name == "x.lis" { &["--cycle-time", "1ms"] } else { &[] };
            let options = [options, &["--message-format", format]].concat();
            let without = said(name, text, &options);
            assert!(format == "json" || without.starts_with(place), "{without}");
            assert_eq!(said(name, &format!("\u{feff}{text}"), &options), without);
        }
    }
}

fn with_compiler(folder: &Path, compiler: &str, arguments: &[&str]) -> (i32, String) {
    let mut command = Command::new(crate::AXGEN);
    let Output { status, stderr, .. } =
        command.current_dir(folder).env("CC", compiler).args(arguments).output().unwrap();
    (status.code().unwrap(), String::from_utf8(stderr).unwrap())
}

/// A compiler that compiles nothing is the environment; one that refuses a block alone has found a difference.
#[test]
#[cfg(unix)]
fn a_compiler_that_does_not_work_is_the_environment() {
    use std::os::unix::fs::PermissionsExt;
    let folder = started();
    let verify = ["verify", "axes.toml", "--samples", "3"];
    let (code, err) = with_compiler(folder.path(), "false", &verify);
    let expected = "engine c: error[AX018]: the C compiler `false` cannot compile an empty program; mend it, or set CC to \
                    another. It said: nothing\n";
    assert_eq!((code, err.as_str()), (3, expected));
    let (code, err) = with_compiler(folder.path(), "true", &verify);
    assert_eq!(code, 3, "{err}");
    let (code, err) = with_compiler(folder.path(), "true", &[&verify[..], &["--message-format", "json"]].concat());
    assert_eq!((code, serde_json::from_str::<Value>(&err).unwrap()["code"].as_str()), (3, Some("AX018")));
    let picky = folder.path().join("picky");
    fs::write(&picky, "#!/bin/sh\ncase \"$*\" in *axis_x_ipc.c*) exit 1;; esac\nexec cc \"$@\"\n").unwrap();
    fs::set_permissions(&picky, fs::Permissions::from_mode(0o755)).unwrap();
    assert_eq!(with_compiler(folder.path(), picky.to_str().unwrap(), &verify), (1, String::new()));
}
