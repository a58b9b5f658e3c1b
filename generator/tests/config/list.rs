//! Reading axis lists.

use super::{assert_said, direct, read_list, said};

#[test]
fn many_lines_that_cannot_be_read() {
    let said = said(&direct(&"\u{1}\u{2}\n".repeat(1000)));
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines.len(), 20 * 3 + 2);
    assert_eq!(lines[59], "    write instead: the line without it, or a `#` before the comment");
    assert_said(
        &lines[60..].join("\n"),
        &[
            "x.lis: error[AX110]: 20 lines that no axis list has; the rest is not read",
            "    write instead: the name of an axis list",
        ],
    );
}

#[test]
fn foreign_parameters_are_passed_over_and_counted() {
    let foreign =
        "kenngr.swe_pos 15000000 ( P-AXIS-00178\nantr.x[1][2] MVS_SVS M 3\nlr_param.other 1\nlist_without_value\n";
    let (set, report) = read_list(foreign.to_owned() + &direct("").replace("ipc.", super::IPC));
    assert_eq!((set.unwrap().foreign, report.to_string().as_str()), (4, ""));
}
