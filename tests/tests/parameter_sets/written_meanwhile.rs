//! Sets that another thread writes while the compiled block checks and copies them: what is in use is one of them, whole.

use crate::axes;
use axgen_tests::environment::{by_depth, has};
use axgen_tests::random::rng::Rng;
use generator::generate::axis_files;
use generator::target::{File, TARGETS};
use portable::RealKind;
use std::path::Path;
use std::process::Command;

/// Sets that the block takes over in a run.
const CHANGES: u32 = 200;

/// The structure with the most numbers of [`axes`], in OFF: no fade comes before a set is taken over.
const STRUCTURE: usize = 1;

#[test]
fn a_set_that_is_written_meanwhile_is_taken_over_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let axis = axes::other(STRUCTURE, RealKind::F64, &mut Rng::new(3), axes::FACT);
    for File { name, text } in axis_files(&axis, &TARGETS[..1]).unwrap() {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let others = axes::block(STRUCTURE, &axes::other(STRUCTURE, RealKind::F64, &mut Rng::new(4), axes::FACT));
    let members: Vec<String> = others
        .for_axis
        .program
        .inputs
        .iter()
        .filter_map(|input| others.for_axis.program.in_set(input))
        .map(member)
        .collect();
    let values = axes::set(&others).into_iter().map(|(_, value)| literal(value)).collect::<Vec<_>>().join(", ");
    let copied =
        |from: &str| members.iter().map(|name| format!("        shared.{name} = {from}.{name};\n")).collect::<String>();
    // Structure and number stand before the numbers.
    let is_kept = |(at, name): (usize, &String)| format!("        && state.now[{at}] == of->{name}\n");
    let kept: String = members[2..].iter().enumerate().map(is_kept).collect();
    let driver = include_str!("written_meanwhile.c")
        .replace("VALUES", &values)
        .replace("FIRST", &copied("axis_x_ipc_designed"))
        .replace("SECOND", &copied("other"))
        .replace("KEPT", &kept)
        .replace("CHANGES", &CHANGES.to_string());
    std::fs::write(folder.path().join("driver.c"), driver).unwrap();
    let levels = ["-O0", "-O2", "-Os", "-O1", "-O3"];
    let levels = &levels[..by_depth(2, 3, levels.len())];
    let compilers = [("gcc", "", "gcc"), ("clang", "clang", "clang")].into_iter();
    let is_there = |(compiler, version, package): &(&str, &str, &str)| has(compiler, version, package);
    // In a plain run the first of those that are there.
    for (compiler, ..) in compilers.filter(is_there).take(by_depth(1, 2, 2)) {
        for level in levels {
            let (taken, mixed) = run(compiler, level, folder.path());
            eprintln!("{compiler} {level}: {taken} sets taken over while another thread writes, {mixed} of them mixed");
            assert!(taken >= CHANGES, "{compiler} {level}");
            assert_eq!(mixed, 0, "{compiler} {level}");
        }
    }
}

/// Sets that were taken over, and those among them that are none of the two.
fn run(compiler: &str, level: &str, folder: &Path) -> (u32, u32) {
    let built = Command::new(compiler)
        .args(["-std=gnu99", "-ffp-contract=off", level, "driver.c", "axis_x_ipc.c", "-o", "driver", "-lpthread"])
        .current_dir(folder)
        .output()
        .unwrap();
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let run = Command::new(folder.join("driver")).output().unwrap();
    let text = String::from_utf8_lossy(&run.stdout);
    let mut numbers = text.split_whitespace().map(|number| number.parse().unwrap());
    (numbers.next().unwrap(), numbers.next().unwrap())
}

/// The member of the struct in C.
fn member(path: &str) -> String {
    path.replace(['[', ']'], "").replace('.', "_")
}

fn literal(value: portable::Literal) -> String {
    match value {
        portable::Literal::F64(value) => format!("{value:?}"),
        portable::Literal::U32(value) => format!("{value}u"),
        portable::Literal::I32(value) => value.to_string(),
        other => panic!("{other:?} in a set"),
    }
}
