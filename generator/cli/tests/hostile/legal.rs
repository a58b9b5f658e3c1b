//! Input that looks hostile and is legal: it is generated, and every compiler and checker takes the result.

use super::row::{IPC, list, set};
use std::{fs, path::Path};

rows! {
    a_keyword_of_all: "an axis `if`" => |folder| named(folder, "if");
    a_keyword_of_st: "an axis `end_if`" => |folder| named(folder, "end_if");
    a_type: "an axis `INT`" => |folder| named(folder, "INT");
    a_keyword_of_cpp: "an axis `class`" => |folder| named(folder, "class");
    a_signal: "an axis `reset`" => |folder| named(folder, "reset");
    a_device_of_windows: "an axis `con`" => |folder| named(folder, "con");
    the_longest_name: "an axis name of 32 letters" => |folder| named(folder, &"X".repeat(32));
    comments_of_a_set: "a set whose comments try to end comments" => |folder| {
        set(folder, format!("# */ *) ]]> --> ''' \"\"\" \\\n{} # */ #error\n", text("X")))
    };
    comments_of_a_list: "a list whose comments try to end comments, in every byte" => |folder| {
        let mut bytes = b"# */ *) ]]> ?\\".to_vec();
        bytes.extend((0..=255).filter(|byte| *byte != b'\n'));
        bytes.extend(format!("\n(*/ int x;\n{IPC}.enable ON # */ #error \\\n").bytes());
        list(folder, bytes)
    };
    a_mark_before_a_list: "a list with a byte order mark and CR LF" => |folder| list(folder, format!("\u{feff}{IPC}.enable ON\r\n"));
    a_mark_before_a_set: "a set with a byte order mark and CR LF" => |folder| set(folder, format!("\u{feff}{}", text("X")).replace('\n', "\r\n"));
    a_name_from_a_file: "a list whose file name is `*_;rm -rf.lis`" => |folder| {
        fs::write(folder.join("*_;rm -rf.lis"), format!("{IPC}.enable ON\n")).unwrap();
        ["*_;rm -rf.lis", "--cycle-time", "1ms"].map(str::to_owned).to_vec()
    };
}

fn text(name: &str) -> String {
    format!("cycle_time = \"1ms\"\n[axis.\"{name}\"]\n{IPC}.enable = \"ON\"")
}

/// A set of this axis, for every target.
fn named(folder: &Path, name: &str) -> Vec<String> {
    let mut arguments = set(folder, text(name));
    let targets = ["c", "rust", "st", "twincat", "codesys", "scl"];
    arguments.extend(targets.iter().flat_map(|target| ["--target", target]).map(str::to_owned));
    arguments
}
