//! What a killed run leaves next to its targets, and files of a person that only have such a name.

use super::{axgen, started};
use std::{collections::BTreeMap, fs, path::Path};

pub fn content(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let files = entries.filter(|entry| entry.path().is_file());
    files.map(|entry| (entry.file_name().into_string().unwrap(), fs::read_to_string(entry.path()).unwrap())).collect()
}

#[test]
fn a_file_of_a_person_stays_whatever_its_name_is() {
    let folder = started();
    fs::write(folder.path().join("mine"), "mine\n").unwrap();
    // The folder of the set itself, and one below it.
    for (out, target) in [(".", "c"), ("generated", "c"), ("generated", "twincat")] {
        let generate = || axgen(folder.path(), &["generate", "axes.toml", "--out", out, "--target", target]).0;
        assert_eq!(generate(), 0);
        let below = folder.path().join(out).join(if target == "twincat" { "twincat/POUs" } else { "" });
        let mine = [
            "notes.axgen-staged-1",
            "notes.axgen-kept-1",
            "axis_y_ipc.c.axgen-staged-7",
            ".axgen-staged-1",
            "x.axgen-kept-1",
        ];
        for (name, text) in mine.iter().zip(["mine\n", "mine\n", "", "mine\n", "a note on\nchecksum of it\n"]) {
            fs::write(below.join(name), text).unwrap();
        }
        fs::create_dir(below.join("folder.axgen-staged-1")).unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink(folder.path().join("mine"), below.join("axis_x_ipc.c.axgen-staged-2")).unwrap();
        let before = content(&below);
        assert_eq!(generate(), 0);
        assert_eq!(content(&below), before, "{out} {target}");
        assert!(below.join("folder.axgen-staged-1").is_dir());
        for name in before.keys().filter(|name| name.contains(".axgen-")) {
            fs::remove_file(below.join(name)).unwrap();
        }
        fs::remove_dir(below.join("folder.axgen-staged-1")).unwrap();
    }
}

/// In addition to a target of this run anything of that name is; next to another one what bears its right checksum.
#[test]
fn what_a_killed_run_left_is_put_back_or_removed() {
    let folder = started();
    let out = folder.path().join("generated");
    let generate = || axgen(folder.path(), &["generate", "axes.toml", "--target", "c"]);
    assert_eq!(generate().0, 0);
    let result = content(&out);
    let text = &result["axis_x_ipc.c"];
    for (name, text) in [
        ("axis_x_ipc.c.axgen-staged-1", &text[..10]),
        ("axis_x_ipc.h.axgen-staged-1", ""),
        ("axis_x_ipc.c.axgen-kept-1", "edited by hand\n"),
        ("axis_gone_ipc.c.axgen-staged-1", text),
    ] {
        fs::write(out.join(name), text).unwrap();
    }
    assert_eq!(generate().0, 0);
    assert_eq!(content(&out), result);
    // A target that is missing gets its old content back; that of an axis that is in the set no more too.
    fs::rename(out.join("axis_x_ipc.c"), out.join("axis_x_ipc.c.axgen-kept-1")).unwrap();
    fs::write(out.join("axis_gone_ipc.c.axgen-kept-1"), text).unwrap();
    let (code, said, _) = generate();
    assert!(code == 0 && said.ends_with("1 axis: 0 files written, 4 unchanged, 0 warnings\n"), "{said}");
    let mut with_gone = result.clone();
    with_gone.insert("axis_gone_ipc.c".to_owned(), text.clone());
    assert_eq!(content(&out), with_gone);
    // What was edited by hand comes back too, and is judged as ever.
    fs::remove_file(out.join("axis_x_ipc.c")).unwrap();
    fs::write(out.join("axis_x_ipc.c.axgen-kept-1"), "mine\n").unwrap();
    let (code, _, err) = generate();
    let said = "generated/axis_x_ipc.c: error[AX014]: was not generated, or its line `checksum` was taken out; nothing was written\n    \
                write instead: the change in what the file is made from; or overwrite it with --force\n";
    assert_eq!((code, err.as_str()), (2, said));
    assert_eq!(fs::read_to_string(out.join("axis_x_ipc.c")).unwrap(), "mine\n");
}
