//! What the readers and the check say, to the letter; files are in memory.

mod advice;
mod apply;
mod arbitrary;
mod canonical;
mod control;
mod every_rule;
mod examples;
mod excitation;
mod files;
mod inert;
mod lines;
mod list;
mod looks_wrong;
mod messages;
mod phase;
mod position_loop;
mod set;
mod spellings;
mod spindle_limits;
mod spindle_words;
mod wording;

use generator::config::{ListOptions, Unreadable};
use generator::diagnostics::Report;
use generator::pipeline::{Set, read_with};
use std::path::Path;

/// One axis list `x.lis` at a cycle time of 1 ms.
fn read_list(text: impl AsRef<[u8]>) -> (Option<Set>, Report) {
    let options = ListOptions { cycle_time: Some("1ms".to_owned()), ..ListOptions::default() };
    read("x.lis", &[("x.lis", text.as_ref())], &options)
}

fn read_set(text: impl AsRef<[u8]>) -> (Option<Set>, Report) {
    read("set.toml", &[("set.toml", text.as_ref())], &ListOptions::default())
}

fn read(path: &str, files: &[(&str, &[u8])], options: &ListOptions) -> (Option<Set>, Report) {
    let load = |path: &Path| {
        let found = files.iter().find(|(name, _)| path == Path::new(name));
        found.map(|(_, bytes)| bytes.to_vec()).ok_or(Unreadable::System("there is no such file".to_owned()))
    };
    let (set, report) = read_with(Path::new(path), options, &load);
    assert_eq!(set.is_none(), report.has_errors(), "{report}");
    (set, report)
}

/// What is said about a list; an abbreviation: `ipc.` begins the paths of improved position control.
fn said(text: &str) -> String {
    short(&read_list(text.replace("ipc.", IPC)).1)
}

fn said_of_set(text: &str) -> String {
    short(&read_set(text).1)
}

/// What is said about an axis of a set with a cycle time of 1 ms; `ipc.` begins paths, as above.
fn said_of_axis(text: &str) -> String {
    said_of_set(&format!("cycle_time = \"1ms\"\n[axis.X]\n{}", text.replace("ipc.", IPC)))
}

fn short(report: &Report) -> String {
    report.to_string().replace(IPC, "ipc.").trim_end().to_owned()
}

const IPC: &str = "lr_param.improved_position_control.";

/// Line for line.
fn assert_said(said: &str, expected: &[&str]) {
    assert_eq!(said.lines().collect::<Vec<_>>(), expected);
}

/// A DIRECT stage that nothing is said about, without what the test itself gives.
fn direct(but: &str) -> String {
    of_mode("DIRECT", "53", "10", but)
}

/// The same, INDIRECT.
fn indirect(but: &str) -> String {
    of_mode("INDIRECT", "11", "2", but)
}

/// The same, SET_POINT.
fn set_point(but: &str) -> String {
    of_mode("SET_POINT", "11", "2", but)
}

fn of_mode(mode: &str, f0: &str, q_factor: &str, but: &str) -> String {
    stage(
        &[
            "ipc.v_add_max_fact 1000",
            &format!("ipc.stage[0].mode {mode}"),
            "ipc.stage[0].filter.order 1",
            &format!("ipc.stage[0].filter.fg_f0 {f0}"),
            &format!("ipc.stage[0].filter.q_factor {q_factor}"),
        ],
        but,
    )
}

/// A gear step of a drive that controls the position.
const OF_DRIVE: &str = "getriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]";

/// A spindle with a changeover in a SERCOS drive that nothing is said about, as keys of a set, without what the test
/// itself gives.
fn sercos(but: &str) -> String {
    spindle("SERCOS", &["antr.nbr_delay_cycles = 4", "antr.sercos.op_mode_for_velocity_control = 1", OF_DRIVE], but)
}

/// The same in a CANopen drive.
fn canopen(but: &str) -> String {
    spindle("CANOPEN", &["antr.nbr_delay_cycles = 4", OF_DRIVE], but)
}

/// The same in the CNC.
fn in_cnc(but: &str) -> String {
    let gear = "getriebe = [{ kv = 10000, multi_gain_z = 10000000, multi_gain_n = 360, dynamik.vb_max = 18000000 }]";
    spindle("CONVENTIONAL", &["antr.nbr_delay_cycles = 1", gear], but)
}

fn spindle(drive: &str, own: &[&str], but: &str) -> String {
    let drive = format!("kenngr.antr_typ = '{drive}'");
    let all = [
        "kenngr.achs_typ = 'ACHSTYP_SPINDEL'",
        &drive,
        "antr.sai_op_mode_change.v_velocity_control_on = 1200000",
        "antr.sai_op_mode_change.v_position_control_on = 300000",
    ];
    stage(&[&all, own].concat(), but)
}

/// `but` first, then those lines whose path it does not give.
fn stage(lines: &[&str], but: &str) -> String {
    let path = |line: &str| line.split_whitespace().next().map(str::to_owned);
    let given: Vec<_> = but.lines().filter_map(path).collect();
    let rest = lines.iter().filter(|line| path(line).is_none_or(|path| !given.contains(&path)));
    std::iter::once(but).chain(rest.copied()).collect::<Vec<_>>().join("\n")
}
