//! Which files are written, named and kept: repeated targets, single axes next to what all share, pages, outputs of a run.

use super::{axgen, started};
use std::{collections::BTreeSet, fs, path::Path};

/// Files below a folder, with `/` between their parts.
fn files(folder: &Path, below: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(folder.join(below)).unwrap().map(|entry| entry.unwrap().file_name());
    let name = |name: std::ffi::OsString| format!("{below}/{}", name.to_string_lossy());
    entries
        .map(name)
        .flat_map(|name| if folder.join(&name).is_dir() { files(folder, &name) } else { BTreeSet::from([name]) })
        .collect()
}

#[test]
fn a_target_that_is_named_twice_counts_once() {
    let folder = started();
    let twice = ["generate", "axes.toml", "--target", "c", "--target", "st", "--target", "c"];
    let (code, out, err) = axgen(folder.path(), &[&twice[..], &["--check"]].concat());
    let ends = ["ipc.h", "ipc.c", "ipc_self_test.c", "ipc.st", "ipc_self_test.st", "commissioning.md"];
    let not_there = ends.map(|end| format!("generated/axis_x_{end}: is not there\n")).concat();
    assert_eq!((code, out, err.as_str()), (1, not_there + "generated/axgen.manifest: is not there\n", ""));
    let (code, out, err) = axgen(folder.path(), &twice);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.ends_with("1 axis: 6 files written, 0 unchanged, 0 warnings\n"), "{out}");
}

/// A set of three axes, one of them in single precision.
fn three() -> tempfile::TempDir {
    let folder = started();
    let axes = [("X", "f64"), ("Y", "f64"), ("Z", "f32")];
    let axes = axes.map(|(name, real)| format!("[axis.{name}]\nreal = \"{real}\"\ngetriebe = [{{ }}]\n"));
    fs::write(folder.path().join("set.toml"), format!("cycle_time = \"1ms\"\n{}", axes.concat())).unwrap();
    folder
}

fn generate(folder: &Path, more: &str) -> (i32, String) {
    let (code, out, _) = axgen(folder, &format!("generate set.toml {more}").split(' ').collect::<Vec<_>>());
    (code, out)
}

/// What the project file names, and what the test program runs.
fn named(folder: &Path) -> (BTreeSet<String>, usize) {
    let read = |name: &str| fs::read_to_string(folder.join("generated/twincat").join(name)).unwrap();
    let project = read("axgen.plcproj-fragment");
    let entries =
        project.lines().filter_map(|line| line.trim().strip_prefix("<Compile Include=\"")?.strip_suffix("\">"));
    let entries = entries.map(|entry| format!("generated/twincat/{}", entry.replace('\\', "/"))).collect();
    (entries, read("Tests/PRG_axgen_tests.TcPOU").matches(" : FB_").count())
}

/// All files that a project has to name.
fn objects(folder: &Path) -> BTreeSet<String> {
    let mut files = files(folder, "generated/twincat");
    files.retain(|name| !name.ends_with("axgen.plcproj-fragment") && !name.ends_with("IMPORT.md"));
    files
}

/// Axes that are written one by one end with the folder of the whole set; on the way the project names what is there.
#[test]
fn a_project_names_the_files_that_are_there() {
    let folder = three();
    let path = folder.path();
    for (count, (axis, left_out)) in [("Y", Some("X, Z")), ("X", Some("Z")), ("Z", None)].into_iter().enumerate() {
        let (code, out) = generate(path, &format!("--target twincat --axis {axis}"));
        assert_eq!(code, 0);
        let told = left_out
            .map(|axes| format!("twincat: the shared files leave out {axes}: their files are not in generated\n"));
        assert_eq!(out.contains("leave out"), told.is_some(), "{out}");
        assert!(out.ends_with(told.as_deref().unwrap_or(" warnings\n")) || told.is_none(), "{out}");
        assert_eq!(named(path), (objects(path), count + 1));
        assert_eq!(generate(path, &format!("--target twincat --axis {axis} --check")), (0, String::new()));
    }
    assert_eq!(generate(path, "--target twincat --check"), (0, String::new()), "as if all had been written at once");
}

/// Writing one axis anew takes none of the others out of the files that they share.
#[test]
fn a_single_axis_keeps_what_the_others_share() {
    let folder = three();
    let path = folder.path();
    for target in ["twincat", "codesys"] {
        assert_eq!(generate(path, &format!("--target {target}")).0, 0);
        let (_, out) = generate(path, &format!("--target {target} --axis X"));
        assert!(out.contains("1 axis: 0 files written, "), "{out}");
        assert!(!out.contains("leave out"), "{out}");
        assert_eq!(generate(path, &format!("--target {target} --check")), (0, String::new()));
    }
    // CODESYS shares the function of each real type.
    let (_, out) = generate(path, "--target codesys --axis X --out other");
    assert!(out.ends_with("codesys: the shared files leave out Y, Z: their files are not in other\n"), "{out}");
    let (_, out) = generate(path, "--target c --axis X --out other");
    assert!(!out.contains("leave out"), "{out}");
}

/// What is there of one target says nothing of another.
#[test]
fn each_target_has_its_own_files() {
    let folder = three();
    let path = folder.path();
    assert_eq!(generate(path, "--target twincat --axis Y").0, 0);
    assert_eq!(generate(path, "--target codesys --axis Z").0, 0);
    let (code, out) = generate(path, "--target c --target twincat --target codesys --axis X");
    assert_eq!(code, 0);
    let told = "twincat: the shared files leave out Z: their files are not in generated\n";
    assert!(out.ends_with(told) && !out.contains("codesys: "), "{out}");
    assert_eq!(named(path), (objects(path), 2));
    let shared = fs::read_to_string(path.join("generated/axgen_shared.xml")).unwrap();
    assert!(shared.contains("F_axgen_in_range_LREAL") && shared.contains("F_axgen_in_range_REAL"), "{shared}");
}

#[test]
fn pages_are_written_as_files_are() {
    let folder = started();
    let man = |more: &[&str]| axgen(folder.path(), &[&["man", "pages"], more].concat());
    let page = folder.path().join("pages/axgen-run.1");
    assert_eq!(man(&[]).0, 0);
    let written = fs::read_to_string(&page).unwrap();
    assert!(written.starts_with(".ig\ngenerated by axgen "), "{written}");
    // Pages of another version bear their checksum too.
    fs::write(&page, generator::digest::with_checksum(format!("older\nchecksum {}\n", generator::digest::NO_CHECKSUM)))
        .unwrap();
    assert_eq!(man(&[]).0, 0);
    assert!(fs::read_to_string(&page).unwrap() == written);
    for (mine, code) in [("mine\n", "AX014"), (&*written.replace("SYNOPSIS", "synopsis"), "AX013")] {
        fs::write(&page, mine).unwrap();
        fs::remove_file(folder.path().join("pages/axgen.1")).unwrap();
        let (exit, out, err) = man(&[]);
        assert_eq!((exit, out.as_str()), (2, ""));
        assert!(err.starts_with(&format!("pages/axgen-run.1: error[{code}]: was ")), "{err}");
        assert!(fs::read_to_string(&page).unwrap() == mine);
        assert!(!folder.path().join("pages/axgen.1").exists(), "nothing was written");
        assert_eq!(man(&["--force"]).0, 0);
        assert!(fs::read_to_string(&page).unwrap() == written);
    }
}

/// A run replaces the outputs of an earlier one, but none of its own inputs, by whatever name.
#[test]
fn a_run_keeps_its_inputs() {
    let folder = started();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("in.csv"), "v_motor\n1.0\n").unwrap();
    fs::hard_link(path("in.csv"), path("link.csv")).unwrap();
    let run = |more: &[&str]| axgen(folder.path(), &[&["run", "axes.toml"], more].concat());
    assert_eq!(run(&["--stimulus", "in.csv", "--out", "out.csv"]).0, 0);
    assert_eq!(run(&["--stimulus", "in.csv", "--out", "out.csv"]).0, 0);
    let before = ["in.csv", "out.csv", "axes.toml"].map(|name| fs::read(path(name)).unwrap());
    let others: &[&str] = if cfg!(unix) { &["link.csv"] } else { &[] };
    for out in ["in.csv", "./in.csv", "out.csv", "axes.toml"].iter().chain(others) {
        let (code, said, err) = run(&["--stimulus", "in.csv", "--compare", "out.csv", "--out", out]);
        assert_eq!((code, said.as_str()), (2, ""));
        assert_eq!(err, format!("{out}: error[AX014]: is an input of this run; give another name\n"));
    }
    for option in ["--junit", "--json"] {
        let (code, said, err) = axgen(folder.path(), &["verify", "axes.toml", "--samples", "3", option, "./axes.toml"]);
        assert_eq!((code, said.as_str()), (2, ""));
        assert_eq!(err, "./axes.toml: error[AX014]: is an input of this run; give another name\n");
    }
    assert_eq!(["in.csv", "out.csv", "axes.toml"].map(|name| fs::read(path(name)).unwrap()), before);
}

/// Nor do import and export, whatever force: the list that a set names is an input of its export.
#[test]
fn import_and_export_keep_their_inputs() {
    let folder = started();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("x.lis"), "kopf.achs_nr 1\n").unwrap();
    fs::write(path("set.toml"), "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\n").unwrap();
    let before = ["x.lis", "set.toml"].map(|name| fs::read(path(name)).unwrap());
    for (command, out) in
        [(["import", "x.lis"], "x.lis"), (["export", "set.toml"], "set.toml"), (["export", "set.toml"], "./x.lis")]
    {
        let (code, said, err) = axgen(folder.path(), &[&command[..], &["--out", out, "--force"]].concat());
        assert_eq!((code, said.as_str()), (2, ""));
        assert!(err.ends_with(&format!("{out}: error[AX014]: is an input of this run; give another name\n")), "{err}");
    }
    assert_eq!(["x.lis", "set.toml"].map(|name| fs::read(path(name)).unwrap()), before);
}

/// Two outputs of one run are two files, by whatever name, before the long run.
#[test]
fn two_outputs_are_two_files() {
    let folder = started();
    for arguments in [
        ["verify", "axes.toml", "--json", "r", "--junit", "./r"],
        ["simulate", "axes.toml", "--csv", "./r", "--picture", "r"],
    ] {
        let (code, said, err) = axgen(folder.path(), &arguments);
        assert_eq!((code, said.as_str()), (2, ""), "{err}");
        assert!(err.contains("error[AX014]: is to take two outputs of this run; give two names"), "{err}");
        assert!(!folder.path().join("r").exists());
    }
}
