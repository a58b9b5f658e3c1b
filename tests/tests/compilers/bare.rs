//! What an emitted block asks of a bare processor: no symbol; without a floating-point unit only what the compiler itself has for
//! arithmetic.

use crate::boards::{BOARDS, Board, Emitted};
use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::{has, is_exhaustive};
use portable::RealKind;
use rayon::prelude::*;
use std::process::Command;

const LEVELS: [&str; 5] = ["-O0", "-O1", "-O2", "-O3", "-Os"];

/// Whether the processor computes in this real type by itself.
fn computes(board: &Board, real: RealKind) -> bool {
    match board.name {
        "Cortex-M4F" => real == RealKind::F32,
        "Cortex-M7" | "AArch64" => true,
        _ => false,
    }
}

#[test]
fn objects_for_a_bare_processor_need_no_symbol() {
    let boards: Vec<&Board> =
        BOARDS.iter().filter(|board| board.name.starts_with("Cortex") && board.is_there()).collect();
    if boards.is_empty() || !has("arm-none-eabi-nm", "nm", "binutils-arm-none-eabi") {
        return;
    }
    let cases: Vec<_> = in_both_real_types();
    let cases: Vec<_> =
        cases.iter().filter(|case| is_exhaustive() || title(case).starts_with("axis-in-single")).collect();
    cases.par_iter().for_each(|case| {
        let emitted = Emitted::of(&case.axis, &case.block, 1);
        let folder = tempfile::tempdir().expect("a temporary folder");
        emitted.files.iter().for_each(|file| std::fs::write(folder.path().join(&file.name), &file.text).expect("room"));
        let sources = emitted.files.iter().map(|file| &file.name);
        let sources: Vec<&String> =
            sources.filter(|name| name.ends_with(".c") && !name.ends_with("_runner.c")).collect();
        for (board, level) in boards.iter().flat_map(|board| LEVELS.map(|level| (board, level))) {
            let what = format!("{}, {} {level}", title(case), board.name);
            let mut compile = Command::new("arm-none-eabi-gcc");
            compile.current_dir(folder.path()).args(board.options).args([
                level,
                "-std=c99",
                "-nostdlib",
                "-r",
                "-o",
                "block.o",
            ]);
            let output = compile.args(&sources).output().expect("the compiler starts");
            assert!(output.status.success(), "{what}: {}", String::from_utf8_lossy(&output.stderr));
            let mut nm = Command::new("arm-none-eabi-nm");
            let output = nm.current_dir(folder.path()).args(["-u", "block.o"]).output().expect("nm starts");
            let text = String::from_utf8_lossy(&output.stdout).into_owned();
            let undefined: Vec<&str> = text.split_whitespace().filter(|word| *word != "U").collect();
            let is_allowed = |name: &&str| !computes(board, case.axis.axis.real) && is_arithmetic(name);
            assert!(undefined.iter().all(|name| is_allowed(&name)), "{what}: {undefined:?}");
        }
    });
}

/// What the ABI of ARM names for arithmetic, and what gcc calls to choose of several ways in a `switch` on a Cortex-M0.
fn is_arithmetic(name: &str) -> bool {
    let memory = ["__aeabi_mem"];
    (name.starts_with("__aeabi_") && !memory.iter().any(|begin| name.starts_with(begin)))
        || name.starts_with("__gnu_thumb1_case_")
}
