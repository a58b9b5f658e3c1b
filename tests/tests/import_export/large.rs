//! The list of a whole machine axis: 3,000 lines, mostly of other functions.

use super::{IPC, round_trip};

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

#[test]
fn a_list_of_3000_lines() {
    round_trip(&list());
}
