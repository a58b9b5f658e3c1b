//! A command with limits of time and memory, for the tests whose input could keep it busy for ever.

use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::{sync::mpsc, thread, time::Duration};

/// How much a command may use.
pub struct Limits {
    pub time: Duration,
    /// address space in KiB; where the system knows no such limit, none is set
    pub memory: u32,
}

/// Runs the command, and ends it when its time is over.
pub fn run<'a>(folder: &Path, arguments: impl IntoIterator<Item = &'a str>, input: Stdio, limits: &Limits) -> Output {
    let Limits { time, memory } = *limits;
    let limit = if cfg!(target_os = "linux") { format!("ulimit -v {memory} && ") } else { String::new() };
    let arguments: Vec<&str> = arguments.into_iter().collect();
    let mut command = Command::new("sh");
    command
        .current_dir(folder)
        .env("RAYON_NUM_THREADS", "2")
        .stdin(input)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command.arg("-c").arg(format!("{limit}exec \"$@\"")).args(["sh", crate::AXGEN]).args(&arguments);
    let child = command.spawn().unwrap();
    let id = child.id().to_string();
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || sender.send(child.wait_with_output()));
    let Ok(output) = receiver.recv_timeout(time) else {
        Command::new("kill").args(["-9", &id]).status().unwrap();
        panic!("{}: goes on for more than {time:?}", arguments.join(" "));
    };
    output.unwrap()
}
