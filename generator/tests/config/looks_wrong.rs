//! Numbers that were mostly written in another unit, or in the wrong place: warnings, to the letter.

use super::{direct, read, short};
use generator::config::ListOptions;

/// What is said of an axis `name` whose list has another name.
fn said_of_list(name: &str, in_list: &str) -> String {
    let set = format!("cycle_time = \"1ms\"\n[axis.{name}]\nlist = \"x.lis\"\n");
    let list = direct("").replace("ipc.", super::IPC) + "\nkopf.log_achs_name " + in_list + "\n";
    let files = [("set.toml", set.as_bytes()), ("x.lis", list.as_bytes())];
    short(&read("set.toml", &files, &ListOptions::default()).1)
}

#[test]
fn a_list_of_another_axis() {
    let expected = "x.lis:7:20: warning[AX466]: the list of the axis X has the name of another axis: `Y`\n    \
                    write instead: in [axis.X] the list of this axis, or the axis with the name in the list";
    assert_eq!(said_of_list("X", "Y"), expected);
    for (name, in_list) in [("X", "X"), ("X", "\"x\""), ("Achse_1", "ACHSE1")] {
        assert_eq!(said_of_list(name, in_list), "", "{name} {in_list}");
    }
}
