//! The list of a whole machine axis: 3,000 lines, mostly of other functions. Prints how long the ways take.

use super::{IPC, exported, imported, meaning, round_trip};
use std::hint::black_box;
use std::time::{Duration, Instant};

fn list() -> Vec<u8> {
    let mut list = Vec::new();
    for line in 0..3000 {
        match line % 300 {
            0 => list.extend(format!("\r\n# Abschnitt {line}: f").into_bytes()),
            1 => list.extend(b"\xFCr Achse\r\n"),
            2 if line < 900 => {
                list.extend(format!("{IPC}stage[{}].mode NOT_ACTIVE # Stufe\r\n", line / 300).into_bytes())
            }
            _ => list.extend(
                format!("antr.struktur[{}].wert_{line}\t\t{line}   ( P-AXIS-{line:05} :\r\n", line % 7).into_bytes(),
            ),
        }
    }
    list
}

/// The shortest of ten runs.
fn time<T>(run: impl Fn() -> T) -> Duration {
    let of_one = |_| {
        let start = Instant::now();
        black_box(run());
        start.elapsed()
    };
    (0..10).map(of_one).min().unwrap_or_default()
}

#[test]
#[expect(clippy::print_stdout, reason = "times are looked at, and not asserted")]
fn a_list_of_3000_lines() {
    let list = list();
    let set = round_trip(&list);
    let read = time(|| meaning("x.lis", &list));
    let import = time(|| imported(&list));
    let of_set = time(|| meaning("set.toml", set.as_bytes()));
    let export = time(|| exported(&set));
    println!(
        "3000 lines: list read in {read:?}, imported in {import:?}, set read in {of_set:?}, exported in {export:?}"
    );
}
