//! What is reported about a list, a set or an axis: `messages/*.txt`, one file for each group of rules. No rule stands here.

use super::{IPC, canopen, direct, in_cnc, indirect, read, said, said_of_set, sercos, set_point, short};
use generator::config::ListOptions;
use std::path::{Path, PathBuf};

pub fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/config/messages");
    let entries = folder.read_dir().expect("the messages");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    files
}

#[test]
fn what_is_reported() {
    for file in files() {
        transcript::compare(file, said_of);
    }
}

/// What is reported about an input, which the form completes: a list or a set, or keys of an axis; `at` a cycle time.
fn said_of(form: &str, given: &str) -> String {
    let (form, cycle_time) = form.split_once(" at ").unwrap_or((form, "1ms"));
    let axis =
        |keys: &str| said_of_set(&format!("cycle_time = \"{cycle_time}\"\n[axis.X]\n{}", keys.replace("ipc.", IPC)));
    match form {
        "list" => said(given),
        "DIRECT" => said(&direct(given)),
        "INDIRECT" => said(&indirect(given)),
        "SET_POINT" => said(&set_point(given)),
        "set" => said_of_set(&given.replace("ipc.", IPC)),
        "axis" => axis(given),
        "axis with a stage" => axis(&format!(
            "{given}\nipc.v_add_max_fact = 1\n\
             ipc.stage = [{{ mode = 'DIRECT', filter = [{{ order = 1, fg_f0 = 53, q_factor = 10 }}] }}]"
        )),
        "SERCOS spindle" => axis(&sercos(given)),
        "CANopen spindle" => axis(&canopen(given)),
        "CNC spindle" => axis(&in_cnc(given)),
        "list with gear steps" => {
            let list = "getriebe[0].kv 1000\ngetriebe[2].kv 3000\ngetriebe[0].dynamik.vb_max 500000\ngetriebe[1].dynamik.vb_max 400000";
            said_with(&format!("list = 'x.lis', {given}"), "x.lis", list)
        }
        "axis with a response of 10 cycles" => {
            let line = |k: i32| format!("{},0,{}\n", 0.5 * f64::from(k), -1.8 * f64::from(k));
            let lines: Vec<String> = (1..200).map(line).collect();
            said_with(given, "x.csv", &("frequency [Hz],magnitude [dB],phase [deg]\n".to_owned() + &lines.concat()))
        }
        other => panic!("no such form: {other}"),
    }
}

/// Keys of a set for an axis that names a file.
fn said_with(keys: &str, file: &str, text: &str) -> String {
    let set = format!("cycle_time = '1ms'\naxis.X = {{ {keys} }}");
    let files: [(&str, &[u8]); 2] = [("set.toml", set.as_bytes()), (file, text.as_bytes())];
    short(&read("set.toml", &files, &ListOptions::default()).1)
}
