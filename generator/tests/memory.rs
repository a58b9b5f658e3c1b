//! How much memory the readers take: so many bytes for each byte of the file, whatever is in it. The figures are printed.

#![cfg(target_os = "linux")]
#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use generator::config::ListOptions;
use generator::pipeline::read_with;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Bytes of each input: much more than what a process has anyway.
const SIZE: usize = 1 << 20;
/// Bytes of memory for a byte of a list: the file itself, and a message or a value for each line.
const OF_A_LIST: usize = 40;
/// The same of a set: its tree has 1.5 KB for a table that takes six bytes in the file.
const OF_A_SET: usize = 300;

/// A line of the process's state, in bytes.
fn status(key: &str) -> usize {
    let text = fs::read_to_string("/proc/self/status").unwrap();
    let line = text.lines().find_map(|line| line.strip_prefix(key)).unwrap();
    line.split_whitespace().nth(1).unwrap().parse::<usize>().unwrap() << 10
}

/// The largest growth of the process while it reads.
fn peak(name: &str, bytes: &[u8]) -> usize {
    let options = ListOptions { cycle_time: name.ends_with("lis").then(|| "1ms".to_owned()), ..ListOptions::default() };
    fs::write("/proc/self/clear_refs", "5").unwrap();
    let before = status("VmRSS");
    let _ = read_with(Path::new(name), &options, &|_| Ok(bytes.to_vec()));
    status("VmHWM").saturating_sub(before)
}

fn repeated(piece: &str) -> Vec<u8> {
    piece.bytes().cycle().take(SIZE).collect()
}

fn inputs() -> Vec<(&'static str, Vec<u8>)> {
    let keys: String = (0..SIZE / 12).map(|n| format!("k{n} = 1\n")).collect();
    vec![
        ("comments.lis", repeated("# x\n")),
        ("blank.lis", repeated("\n")),
        ("foreign.lis", repeated("a.b 1\n")),
        ("faults.lis", repeated("lr_param.improved_position_control.enable X\n")),
        ("unknown.lis", repeated("lr_param.improved_position_control.x 1\n")),
        ("line.lis", repeated("x")),
        ("brackets.lis", repeated("[")),
        ("comments.toml", repeated("# x\n")),
        ("brackets.toml", repeated("[")),
        ("braces.toml", repeated("{")),
        ("quotes.toml", repeated("\"")),
        ("points.toml", repeated("a.")),
        ("numbers.toml", [b"x = [".as_slice(), &repeated("1,"), b"]"].concat()),
        ("tables.toml", [b"x = [".as_slice(), &repeated("{a=1},"), b"]"].concat()),
        ("keys.toml", keys.into_bytes()),
    ]
}

/// Says to this program which input it shall measure: each in a process of its own, for what one frees another would use.
const INPUT: &str = "AXGEN_MEMORY_INPUT";

#[test]
#[expect(clippy::print_stdout, reason = "the figures")]
fn memory_is_bounded_by_the_size_of_the_file() {
    let wanted = std::env::var(INPUT).ok();
    for (name, bytes) in inputs() {
        match &wanted {
            None => {
                let program = std::env::current_exe().unwrap();
                let status = Command::new(program).arg("--nocapture").env(INPUT, name).status().unwrap();
                assert!(status.success(), "{name}");
            }
            Some(wanted) if wanted == name => {
                let each = peak(name, &bytes) / bytes.len();
                println!("{name:16} {each:4} bytes of memory a byte");
                assert!(each <= if name.ends_with("lis") { OF_A_LIST } else { OF_A_SET }, "{name}: {each}");
            }
            Some(_) => {}
        }
    }
}
