//! Single files that commands write: which ones they replace, that no link leads elsewhere, and that nothing is left
//! of a failure.

use super::{axgen, started, write_case};
use crate::AXGEN;
use std::{fs, path::Path};

const FOREIGN: &str = "is not an earlier output of this command; give another name, or --force to replace it";

/// The commands that are run again and again, each with the file that it writes.
const AGAIN: [&str; 4] = [
    "run axes.toml --stimulus in.csv --out file",
    "verify axes.toml --samples 3 --engine program --junit file",
    "verify axes.toml --samples 3 --engine program --json file",
    "golden verify case --json file",
];

/// The commands that write a file once.
const ONCE: [(&str, &str); 3] = [
    ("init file.toml", "give another name"),
    ("import x.lis --cycle-time 1ms --out file.toml", "give another name, or --force to replace it"),
    ("export axes.toml --out file", "give another name, or --force to replace it"),
];

fn folder() -> tempfile::TempDir {
    let folder = started();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("in.csv", "v_motor\n1.0\n");
    write("x.lis", "kopf.achs_nr 1\n");
    write_case(folder.path());
    assert_eq!(axgen(folder.path(), &["golden", "record", "case"]).0, 0);
    folder
}

fn run(folder: &Path, arguments: &str) -> (i32, String) {
    let (code, _, err) = axgen(folder, &arguments.split(' ').collect::<Vec<_>>());
    // `export` warns of a key that no list has.
    let at = err.trim_end().rfind('\n').map_or(0, |end| end + 1);
    (code, err[at..].replace("file.toml", "file"))
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn results_replace_earlier_results_and_no_other_file() {
    let folder = folder();
    let file = folder.path().join("file");
    for command in AGAIN {
        assert_eq!(run(folder.path(), command), (0, String::new()), "{command}");
        let first = fs::read(&file).unwrap();
        assert_eq!(run(folder.path(), command), (0, String::new()), "an earlier output: {command}");
        assert_eq!(fs::read(&file).unwrap(), first);
        fs::write(&file, "").unwrap();
        assert_eq!(run(folder.path(), command), (0, String::new()), "an empty file: {command}");
        for foreign in
            ["mine\n", "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<testsuites>\n", "{\n  \"failures\": 1 }"]
        {
            fs::write(&file, foreign).unwrap();
            assert_eq!(run(folder.path(), command), (2, format!("file: error[AX014]: {FOREIGN}\n")), "{command}");
            assert_eq!(fs::read_to_string(&file).unwrap(), foreign);
        }
        assert_eq!(run(folder.path(), &format!("{command} --force")), (0, String::new()));
        assert_eq!(fs::read(&file).unwrap(), first);
        fs::remove_file(&file).unwrap();
    }
}

#[test]
fn sets_and_lists_replace_nothing_unasked() {
    let folder = folder();
    for (command, instead) in ONCE {
        let file = folder.path().join(command.rsplit(' ').next().unwrap());
        for there in ["", "mine\n"] {
            fs::write(&file, there).unwrap();
            let said = format!("file: error[AX014]: is there already; {instead}\n");
            assert_eq!(run(folder.path(), command), (2, said));
            assert_eq!(fs::read_to_string(&file).unwrap(), there);
        }
        fs::remove_file(&file).unwrap();
        assert_eq!(run(folder.path(), command).0, 0);
        fs::remove_file(&file).unwrap();
    }
}

/// Neither with --force: what lies after a link, and a device, is nobody's output.
#[test]
#[cfg(unix)]
fn nothing_is_written_through_a_link_or_into_a_device() {
    let folder = folder();
    let files = ["file", "file.toml"].map(|name| folder.path().join(name));
    let commands = AGAIN.into_iter().chain(ONCE.map(|(command, _)| command));
    let forced =
        AGAIN.into_iter().chain(ONCE[1..].iter().map(|(command, _)| *command)).map(|of| format!("{of} --force"));
    let commands: Vec<String> = commands.map(str::to_owned).chain(forced).collect();
    for target in ["mine", "not-there"] {
        fs::write(folder.path().join("mine"), "").unwrap();
        files.iter().for_each(|file| std::os::unix::fs::symlink(target, file).unwrap());
        for command in &commands {
            let said =
                "file: error[AX017]: is a symbolic link, through which nothing is written; nothing was written\n";
            assert_eq!(run(folder.path(), command), (3, said.to_owned()), "{command}");
        }
        assert_eq!(fs::read_to_string(folder.path().join("mine")).unwrap(), "");
        assert!(!folder.path().join("not-there").exists());
        files.iter().for_each(|file| fs::remove_file(file).unwrap());
    }
    for command in commands.iter().map(|command| command.replace("file.toml", "file")) {
        let said = "/dev/null: error[AX017]: is not a regular file; nothing was written\n";
        assert_eq!(run(folder.path(), &command.replace("file", "/dev/null")), (3, said.to_owned()), "{command}");
    }
}

/// A limit on the size of files gives the errors of a full disk.
#[test]
#[cfg(unix)]
fn a_disk_that_is_full_keeps_what_was_there_and_gets_nothing() {
    let folder = folder();
    let full = |command: &str| {
        let mut shell = std::process::Command::new("sh");
        shell.current_dir(folder.path()).args(["-c", "trap '' XFSZ; ulimit -f 0; exec \"$0\" \"$@\"", AXGEN]);
        let output = shell.args(command.split(' ')).output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap().replace("file.toml", "file");
        (output.status.code(), err[err.find("file: ").unwrap()..].to_owned())
    };
    let said = "file: error[AX017]: File too large (os error 27); nothing was written\n";
    let before = names(folder.path());
    for command in AGAIN.into_iter().chain(ONCE.map(|(command, _)| command)) {
        assert_eq!(full(command), (Some(3), said.to_owned()), "{command}");
        assert_eq!(names(folder.path()), before, "{command}");
    }
    // Of two results the first is not there without the second.
    let both = "verify axes.toml --samples 3 --engine program --junit other --json file";
    fs::create_dir(folder.path().join("file")).unwrap();
    let (code, err) = run(folder.path(), both);
    assert_eq!((code, err.as_str()), (3, "file: error[AX017]: is a directory; nothing was written\n"));
    assert!(!folder.path().join("other").exists());
    fs::remove_dir(folder.path().join("file")).unwrap();
    for command in AGAIN {
        assert_eq!(run(folder.path(), command).0, 0);
        let first = fs::read(folder.path().join("file")).unwrap();
        assert_eq!(full(command), (Some(3), said.to_owned()), "{command}");
        assert_eq!(fs::read(folder.path().join("file")).unwrap(), first);
        fs::remove_file(folder.path().join("file")).unwrap();
    }
    assert_eq!(names(folder.path()), before);
}
