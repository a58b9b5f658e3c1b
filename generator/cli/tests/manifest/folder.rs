//! A folder with sets and what they generated, and what happens to it between two runs.

use crate::{AXGEN, Run as Said};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{collections::BTreeMap, fs};
use std::{thread::sleep, time::Duration};
use tempfile::TempDir;

/// What somebody writes into a file: it is never lost.
pub const MINE: &str = "mine\n";

pub const OUT: &str = "generated";

pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    fn command(&self, arguments: &str, out: &str) -> Command {
        let mut command = Command::new(AXGEN);
        command.current_dir(self.path()).arg("generate").args(arguments.split(' ')).args(["--out", out]);
        command
    }

    pub fn generate(&self, arguments: &str, out: &str) -> Said {
        let output = self.command(arguments, out).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Said { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
    }

    /// A step of `ways.toml`.
    pub fn happens(&self, step: &str) {
        let path = |file: &str| self.path().join(OUT).join(file);
        let (what, rest) = step.split_once(' ').unwrap_or((step, ""));
        let (first, more) = rest.split_once(' ').unwrap_or((rest, ""));
        match what {
            "set" => {
                let [file, targets, axes] = rest.split(" | ").collect::<Vec<_>>()[..] else { panic!("{step}") };
                fs::write(self.path().join(file), set(targets, axes)).unwrap();
            }
            "run" => {
                let said = self.generate(rest, OUT);
                assert_eq!(said.code, 0, "{rest}: {}", said.err);
            }
            "kill" => self.kill(more, Duration::from_micros(first.parse().unwrap())),
            "edit" => {
                let text = fs::read_to_string(path(rest)).unwrap();
                fs::write(path(rest), text + MINE).unwrap();
            }
            "put" => {
                let (file, text) = rest.split_once(" | ").unwrap_or((rest, MINE));
                fs::write(path(file), text).unwrap();
            }
            "delete" => fs::remove_file(path(rest)).unwrap(),
            "rename" => fs::rename(path(first), path(more)).unwrap(),
            "carriage" => self.rewrite("", |text| text.replace('\n', "\r\n")),
            "save" => self.rewrite("Tc", saved),
            "merge" => self.rewrite("manifest", |text| {
                let lines: Vec<&str> = text.lines().collect();
                let both = lines.iter().chain(&["# another branch", ""]).chain(lines.iter().rev());
                both.map(|line| format!("{line}\r\n")).collect()
            }),
            #[cfg(unix)]
            "link" => {
                fs::remove_file(path(rest)).unwrap();
                fs::write(self.path().join("elsewhere"), MINE).unwrap();
                std::os::unix::fs::symlink(self.path().join("elsewhere"), path(rest)).unwrap();
            }
            _ => panic!("no such step: {step}"),
        }
    }

    /// A run that is killed some time after it has replaced the manifest, which comes first.
    fn kill(&self, arguments: &str, after: Duration) {
        let manifest = || fs::metadata(self.path().join(OUT).join("axgen.manifest")).unwrap().modified().unwrap();
        let before = manifest();
        let mut command = self.command(arguments, OUT);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        while manifest() == before && child.try_wait().unwrap().is_none() {}
        sleep(after);
        let _ = child.kill(); // it may have ended
        child.wait().unwrap();
    }

    /// Writes the files anew whose extension begins so.
    fn rewrite(&self, begins: &str, change: impl Fn(&str) -> String) {
        for (file, text) in self.content(OUT) {
            if file.rsplit_once('.').is_some_and(|(_, end)| end.starts_with(begins)) {
                fs::write(self.path().join(OUT).join(file), change(&text)).unwrap();
            }
        }
    }

    /// The files below a folder, by their names with `/`, and their texts.
    pub fn content(&self, folder: &str) -> BTreeMap<String, String> {
        let (root, mut found) = (self.path().join(folder), BTreeMap::new());
        let mut folders: Vec<PathBuf> = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for path in fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap().path()) {
                if path.is_dir() {
                    folders.push(path);
                } else {
                    let name = path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
                    found.insert(name, fs::read_to_string(&path).unwrap());
                }
            }
        }
        found
    }
}

/// A set: each axis has a name and words.
fn set(targets: &str, axes: &str) -> String {
    let list = targets.split(' ').map(|target| format!("\"{target}\"")).collect::<Vec<_>>().join(", ");
    let targets = if targets == "-" { String::new() } else { format!("targets = [{list}]\n") };
    axes.split(", ").map(axis).fold(format!("cycle_time = \"1ms\"\n{targets}"), |set, axis| set + &axis)
}

fn axis(axis: &str) -> String {
    let (name, words) = axis.split_once(' ').unwrap_or((axis, ""));
    let has = |word: &str| words.split(' ').any(|of| of == word);
    let line = |word: &str, text: &str| if has(word) { format!("{text}\n") } else { String::new() };
    let stage = "lr_param.improved_position_control = { enable = \"ON\", v_add_max_fact = 100, stage = [{ mode = \"DIRECT\", \
                 weight_fact_num = 3, weight_fact_denom = 10, filter = [{ order = 1, fg_f0 = 53.0, q_factor = 5.0 }] }] }";
    let kv = if has("kv") { "kv = 2000, multi_gain_n = 1, multi_gain_z = 2000, " } else { "" };
    [
        format!("[axis.{name}]\nkenngr.antr_typ = \"CONVENTIONAL\"\ngetriebe = [{{ {kv}dynamik = {{ vb_max = 500000 }} }}]\n"),
        line("stage", stage),
        line("f32", "real = \"f32\""),
        line("tunable", "tunable = \"all\""),
    ]
    .concat()
}

/// An object as TwinCAT saves it: its version, the numbers of the lines after all members, other line ends, none at the end.
fn saved(text: &str) -> String {
    let text = text.replacen(
        "<TcPlcObject Version=\"1.1.0.1\">",
        "<TcPlcObject Version=\"1.1.0.1\" ProductVersion=\"3.1.4024.53\">",
        1,
    );
    let ids = |name: &str| {
        format!(
            "    <LineIds Name=\"{name}\">\n      <LineId Id=\"3\" Count=\"41\" />\n      <LineId Id=\"2\" Count=\"0\" />\n    </LineIds>\n"
        )
    };
    let ids = if text.contains("<Method ") { ids("FB") + &ids("FB.gives") } else { ids("FB") };
    let text = text.replace("  </POU>\n", &format!("{ids}  </POU>\n"));
    text.trim_end().replace('\n', "\r\n")
}
