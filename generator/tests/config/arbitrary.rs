//! Long files; and the list of codes matches what is said. Random files: `tests/tests/readers`.

use super::read_set;
use generator::codes::CODES;
use std::fs;

/// A hostile file must not make the messages cost more than the file: here one line of a megabyte with 50,000 faults.
#[test]
fn one_long_line() {
    let many = "{ '\u{e4}\u{e4}' = 1, b = 2 }, ".repeat(50_000);
    let (_, report) = read_set(format!("cycle_time = \"1ms\"\n[axis.X]\ngetriebe = [{many}]"));
    let last = report.diagnostics.last().unwrap().to_string();
    assert_eq!(report.diagnostics.len(), 1001);
    assert_eq!(last, "set.toml: error[AX010]: 99000 more messages are not listed");
}

/// Every code is asserted somewhere in these tests; those of the command line in its own.
#[test]
fn every_code_has_a_test() {
    let tests = [
        include_str!("every_rule.rs"),
        include_str!("excitation.rs"),
        include_str!("arbitrary.rs"),
        include_str!("files.rs"),
        include_str!("looks_wrong.rs"),
        include_str!("../real_files/kinds.rs"),
        include_str!("../real_files/mistakes.txt"),
        include_str!("../real_files/nc_axes.rs"),
        include_str!("../real_files/projects.rs"),
        include_str!("../response_file/defects.txt"),
        include_str!("../response_file/doubtful.txt"),
        include_str!("../response_file/sinumerik.txt"),
        include_str!("../../cli/tests/front_door/ends.txt"),
        include_str!("../../cli/tests/front_door/messages.rs"),
        include_str!("../../cli/tests/manifest/mod.rs"),
        include_str!("../../cli/tests/manifest/ways.toml"),
        include_str!("../../cli/tests/measured/measure.rs"),
        include_str!("../../cli/tests/measured/stages.rs"),
        include_str!("../../cli/tests/params_of.rs"),
        include_str!("../../cli/tests/params_of.txt"),
        include_str!("../../cli/tests/recordings/evidence.rs"),
        include_str!("../../cli/tests/recordings/refused.rs"),
        include_str!("../../cli/tests/scenario.txt"),
        include_str!("../../cli/tests/measured/tune.rs"),
    ];
    let messages = super::messages::files().iter().map(|file| fs::read_to_string(file).unwrap()).collect::<String>();
    let tests = [&[messages.as_str()], &tests[..]].concat();
    for code in CODES {
        assert!(tests.iter().any(|test| test.contains(code.code)), "{} has no test", code.code);
    }
}
