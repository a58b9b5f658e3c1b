//! Running the command with limits of time and memory; looking at folders.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// How the command ended.
pub struct Run {
    /// its exit code
    pub code: i32,
    /// standard output
    pub out: String,
    /// standard error
    pub err: String,
}

/// No input may keep the command busy for longer.
const TIME: Duration = Duration::from_secs(10);

/// Address space in KiB. Where the system knows no such limit, none is set.
const LIMIT: &str = if cfg!(target_os = "linux") { "ulimit -v 1048576 && " } else { "" };

/// Runs the command.
pub fn axgen<'a>(folder: &Path, arguments: impl IntoIterator<Item = &'a str>) -> Run {
    let mut command = Command::new("sh");
    command.current_dir(folder).env("RAYON_NUM_THREADS", "2").stdin(Stdio::null());
    command.arg("-c").arg(format!("{LIMIT}exec \"$@\"")).arg("sh").arg(env!("CARGO_BIN_EXE_axgen")).args(arguments);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let id = child.id().to_string();
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || sender.send(child.wait_with_output()));
    let Ok(output) = receiver.recv_timeout(TIME) else {
        Command::new("kill").args(["-9", &id]).status().unwrap();
        panic!("it goes on for more than {TIME:?}");
    };
    let output = output.unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    let code = output.status.code().unwrap_or_else(|| panic!("{}: {err}", output.status));
    Run { code, out: String::from_utf8(output.stdout).unwrap(), err }
}

/// All that is below a folder.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if fs::symlink_metadata(&path).unwrap().is_dir() {
            found.extend(files(&path));
        }
        found.push(path);
    }
    found.sort();
    found
}

/// The files below a folder with what is in them.
pub fn read_result(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let regular = files(folder).into_iter().filter(|path| path.is_file());
    regular.map(|path| (path.strip_prefix(folder).unwrap().to_owned(), fs::read(&path).unwrap())).collect()
}
