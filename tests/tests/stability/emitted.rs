//! Emitted C in a loop with the ideal drive: the blocks of some axes in one program, which prints how much each loop grows.

use generator::blocks::Designed;
use generator::generate::axis_files;
use generator::target::TARGETS;
use std::fmt::Write;
use std::process::Command;

const LOOP: &str = include_str!("emitted.c");

/// How much the loop of each axis grows, by the block `ipc` that is emitted for it; the names of the axes differ.
pub fn growths(axes: &[Designed]) -> Vec<f64> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (mut included, mut calls) = (String::new(), String::new());
    for axis in axes {
        for file in axis_files(axis, &TARGETS[..1]).expect("the target prints the block") {
            std::fs::write(folder.path().join(&file.name), &file.text).expect("room in it");
            if let Some(stem) = file.name.strip_suffix("_ipc.c") {
                let _ = writeln!(included, "#include \"{}\"", file.name);
                let _ = writeln!(calls, "    GROWTH({stem}_ipc)");
            }
        }
    }
    let text = format!("{included}{LOOP}int main(void)\n{{\n{calls}    return 0;\n}}\n");
    std::fs::write(folder.path().join("loops.c"), text).expect("room in it");
    let said = Command::new("cc")
        .args(["-std=c99", "-O1", "loops.c", "-o", "loops", "-lm"])
        .current_dir(folder.path())
        .output()
        .expect("the compiler `cc` starts");
    assert!(said.status.success(), "{}", String::from_utf8_lossy(&said.stderr));
    let output = Command::new(folder.path().join("loops")).output().expect("the program starts");
    let text = String::from_utf8(output.stdout).expect("it prints numbers");
    let growths: Vec<f64> = text.lines().map(|line| line.parse().expect("it prints numbers")).collect();
    assert_eq!(growths.len(), axes.len());
    growths
}
