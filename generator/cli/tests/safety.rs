//! Files end to end: a folder that takes none, a full disk, killed runs, runs side by side. No test here needs to be root,
//! and none is passed over by root, whom no permission binds.

use crate::{AXGEN, is_exhaustive};
use generator::digest::has_right_checksum;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::{collections::BTreeMap, fs};
use tempfile::TempDir;

/// A user without any right of its own.
const NOBODY: u32 = 65534;

/// A folder with a set of so many axes, whose files depend on the cycle time.
fn folder(axes: usize) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for cycle_time in ["1ms", "2ms"] {
        let axes: String = (0..axes).map(|n| format!("[axis.A{n}]\ngetriebe = [{{}}]\n")).collect();
        fs::write(folder.path().join(format!("{cycle_time}.toml")), format!("cycle_time = \"{cycle_time}\"\n{axes}"))
            .unwrap();
    }
    folder
}

fn generate(set: &str, out: &str) -> Vec<String> {
    ["generate", set, "--out", out].map(str::to_owned).to_vec()
}

fn axgen(folder: &Path, arguments: &[String]) -> Output {
    Command::new(AXGEN).current_dir(folder).args(arguments).output().unwrap()
}

fn said(output: &Output) -> (Option<i32>, String) {
    let err = String::from_utf8_lossy(&output.stderr);
    // What is said about the axes themselves is of no interest here; lines of the set are shown with a bar.
    let of_an_axis = |line: &&str| ["AX401", "instead:", " | "].iter().any(|part| line.contains(part));
    (output.status.code(), err.lines().filter(|line| !of_an_axis(line)).collect())
}

fn content(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    entries.map(|entry| (entry.file_name().into_string().unwrap(), fs::read_to_string(entry.path()).unwrap())).collect()
}

/// What a set gives, in a folder of its own.
fn result(folder: &Path, set: &str) -> BTreeMap<String, String> {
    let out = tempfile::tempdir().unwrap();
    assert_eq!(said(&axgen(folder, &generate(set, out.path().to_str().unwrap()))), (Some(0), String::new()));
    content(out.path())
}

#[test]
fn a_folder_without_the_permission_to_write_is_the_environment() {
    let folder = folder(1);
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o755)).unwrap();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("axis_a0_ipc.c"), "").unwrap();
    fs::set_permissions(&out, fs::Permissions::from_mode(0o555)).unwrap();
    // The folder of the build may be closed to others.
    let program = folder.path().join("axgen");
    fs::copy(AXGEN, &program).unwrap();
    for target in ["out", "out/below"] {
        let mut command = Command::new(&program);
        if fs::metadata(&out).unwrap().uid() == 0 {
            command.uid(NOBODY);
        }
        let output = command.current_dir(folder.path()).args(generate("1ms.toml", target)).output().unwrap();
        let (code, said) = said(&output);
        assert_eq!(code, Some(3), "{said}");
        assert!(said.contains("Permission denied") && said.ends_with("nothing was written"), "{said}");
    }
    assert_eq!(content(&out), BTreeMap::from([("axis_a0_ipc.c".to_owned(), String::new())]));
    fs::set_permissions(&out, fs::Permissions::from_mode(0o755)).unwrap();
}

/// Not even root can make a file there.
#[test]
#[cfg(target_os = "linux")]
fn a_folder_of_the_system_is_the_environment() {
    let (code, said) = said(&axgen(folder(1).path(), &generate("1ms.toml", "/proc")));
    assert_eq!(code, Some(3), "{said}");
    assert!(said.starts_with("/proc/axis_a0_ipc.h: ") && said.ends_with("nothing was written"), "{said}");
}

/// A limit on the size of files gives the errors of a full disk, at any byte of any file.
#[test]
fn a_file_that_cannot_be_written_to_its_end_is_the_environment() {
    let folder = folder(2);
    assert_eq!(axgen(folder.path(), &generate("1ms.toml", "out")).status.code(), Some(0));
    let before = content(&folder.path().join("out"));
    for out in ["out", "new"] {
        for blocks in [0, 1, 4, 8] {
            // The system sends a signal then, which ends a process that does not care.
            let script = format!("ulimit -f {blocks}; exec \"$0\" \"$@\"");
            let mut command = Command::new("sh");
            command.current_dir(folder.path()).arg("-c").arg(script).arg(AXGEN).args(generate("2ms.toml", out));
            let (code, said) = said(&command.output().unwrap());
            assert_eq!(code, Some(3), "{said}");
            assert!(said.contains("File too large") && said.ends_with("nothing was written"), "{said}");
            assert!(!folder.path().join("new").exists());
            assert_eq!(content(&folder.path().join("out")), before);
        }
    }
}

/// A real one, where the system lets us mount it.
#[test]
#[expect(clippy::print_stdout, reason = "why it was not run")]
#[cfg(target_os = "linux")]
fn a_full_disk_is_the_environment() {
    let folder = folder(40);
    fs::create_dir(folder.path().join("disk")).unwrap();
    let script = "mount -t tmpfs -o size=256k tmpfs disk && \"$0\" \"$@\"; code=$?; ls -A disk; exit $code";
    let mut command = Command::new("unshare");
    command.args(["--map-root-user", "--mount", "sh", "-c", script, AXGEN]).args(generate("1ms.toml", "disk/out"));
    let output = command.current_dir(folder.path()).output().unwrap();
    let (code, said) = said(&output);
    if said.contains("unshare") || said.contains("mount:") {
        println!("no disk could be mounted here; the test above stands for it: {said}");
        return;
    }
    assert_eq!(code, Some(3), "{said}");
    assert!(said.contains("No space left on device") && said.ends_with("nothing was written"), "{said}");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "", "the disk is empty again");
}

/// The same of a single file.
#[test]
fn a_single_file_that_cannot_be_written_to_its_end_is_the_environment() {
    let folder = folder(2);
    fs::write(folder.path().join("x.lis"), "kopf.achs_nr 1\n".to_owned() + &"# a comment\n".repeat(1000)).unwrap();
    let mut command = Command::new("sh");
    command.current_dir(folder.path()).args(["-c", "ulimit -f 1; exec \"$0\" \"$@\"", AXGEN]);
    let (code, said) = said(&command.args(["import", "x.lis", "--out", "x.toml"]).output().unwrap());
    assert!(code == Some(3) && said.contains("File too large") && said.ends_with("nothing was written"), "{said}");
    assert_eq!(content(folder.path()).keys().filter(|name| name.starts_with("x.toml")).count(), 0);
}

/// Killed as soon as a file is staged: no target is touched, and the next run clears what is left.
#[test]
fn a_run_that_is_killed_while_it_stages_harms_nothing() {
    let folder = folder(100);
    let out = folder.path().join("out");
    axgen(folder.path(), &generate("1ms.toml", "out"));
    let before = content(&out);
    let mut command = Command::new(AXGEN);
    let mut child = command.current_dir(folder.path()).args(generate("2ms.toml", "out")).spawn().unwrap();
    let is_staged =
        || fs::read_dir(&out).unwrap().any(|entry| is_staged(&entry.unwrap().file_name().to_string_lossy()));
    while !is_staged() && child.try_wait().unwrap().is_none() {}
    child.kill().unwrap();
    assert!(child.wait().unwrap().signal().is_some(), "it was killed before its end");
    let mut after = content(&out);
    let all = after.len();
    after.retain(|name, _| !self::is_staged(name));
    assert!(all > after.len(), "something was staged");
    assert_eq!(after, before);
    assert_eq!(axgen(folder.path(), &generate("2ms.toml", "out")).status.code(), Some(0));
    assert_eq!(content(&out), result(folder.path(), "2ms.toml"));
}

fn is_staged(name: &str) -> bool {
    name.contains(".axgen-staged-")
}

/// Killed as soon as so many files have their new content: each target is whole, old or new, and the next run mends all.
#[test]
fn a_run_that_is_killed_while_it_renames_leaves_whole_files() {
    let folder = folder(40);
    let out = folder.path().join("out");
    let results = ["1ms.toml", "2ms.toml"].map(|set| result(folder.path(), set));
    axgen(folder.path(), &generate("1ms.toml", "out"));
    let last = |count: usize| out.join(results[0].keys().nth(count).unwrap());
    for count in [40, 0, 8, 72, 100].into_iter().take(if is_exhaustive() { 3 } else { 2 }) {
        let inode = || fs::metadata(last(count)).unwrap().ino();
        let before = inode();
        let mut command = Command::new(AXGEN);
        command
            .current_dir(folder.path())
            .args(generate("2ms.toml", "out"))
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        let mut child = command.spawn().unwrap();
        while inode() == before && child.try_wait().unwrap().is_none() {}
        let _ = child.kill();
        child.wait().unwrap();
        for (name, text) in content(&out).iter().filter(|(name, _)| !name.contains(".axgen-")) {
            assert!(results.iter().any(|result| result[name] == *text), "{name} is of one run or the other");
        }
        for (set, result) in ["2ms.toml", "1ms.toml"].iter().zip(results.iter().rev()) {
            assert_eq!(axgen(folder.path(), &generate(set, "out")).status.code(), Some(0));
            assert!(content(&out) == *result, "all of the next run, and nothing else");
        }
    }
}

#[test]
fn runs_side_by_side_end_with_the_result_of_one() {
    let folder = folder(3);
    let results = ["1ms.toml", "2ms.toml"].map(|set| result(folder.path(), set));
    for _ in 0..if is_exhaustive() { 8 } else { 5 } {
        let runs: Vec<_> = (0..8)
            .map(|number| {
                let set = ["1ms.toml", "2ms.toml"][number % 2];
                let mut command = Command::new(AXGEN);
                command.current_dir(folder.path()).args(generate(set, "out")).stdout(Stdio::null());
                command.stderr(Stdio::null()).spawn().unwrap()
            })
            .collect();
        runs.into_iter().for_each(|mut run| assert_eq!(run.wait().unwrap().code(), Some(0)));
        let out = content(&folder.path().join("out"));
        let files = out.iter().filter(|(name, _)| *name != generator::manifest::NAME);
        assert!(files.map(|(_, text)| text).all(|text| has_right_checksum(text) == Some(true)));
        assert!(results.contains(&out), "the files are of one run, and nothing else is left");
    }
}

#[test]
fn a_folder_may_be_named_in_any_way() {
    let folder = folder(1);
    fs::create_dir(folder.path().join("real")).unwrap();
    symlink("real", folder.path().join("link")).unwrap();
    let absolute = folder.path().join("absolute");
    let expected = result(folder.path(), "1ms.toml");
    for (out, place) in
        [("link", "real"), ("real/../up", "up"), (absolute.to_str().unwrap(), "absolute"), ("./d/", "d")]
    {
        assert_eq!(axgen(folder.path(), &generate("1ms.toml", out)).status.code(), Some(0), "{out}");
        assert_eq!(content(&folder.path().join(place)), expected, "{out}");
    }
}
