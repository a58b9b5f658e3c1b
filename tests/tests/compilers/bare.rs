//! What an emitted block asks of a bare processor: no symbol where the processor computes in the block's real type; else only what
//! the compiler itself has for arithmetic.

use crate::boards::{BOARDS, object};
use crate::in_turn;
use crate::runners::blocks;
use axgen_tests::environment::{has, is_exhaustive};
use rayon::prelude::*;
use std::process::Command;

const LEVELS: [&str; 5] = ["-O0", "-O1", "-O2", "-O3", "-Os"];
/// A processor, a real type, and whether the processor computes in it by itself.
const WAYS: [(&str, &str, bool); 4] = [
    ("Cortex-M4F", "f32", true),
    ("Cortex-M7", "f64", true),
    ("Cortex-M0+", "f32", false),
    ("Cortex-M0+", "f64", false),
];

#[test]
fn objects_for_a_bare_processor_need_no_symbol() {
    if !BOARDS[0].is_there() || !has("arm-none-eabi-nm", "nm", "binutils-arm-none-eabi") {
        return;
    }
    let emitted = ["f32", "f64"].map(|real| (real, blocks(real)));
    let levels = |number| if is_exhaustive() { in_turn(&LEVELS, number, 2) } else { LEVELS[2..3].to_vec() };
    let of_way = |(number, way)| levels(number).into_iter().map(move |level| (way, level));
    let runs: Vec<_> = WAYS.iter().enumerate().flat_map(of_way).collect();
    runs.par_iter().for_each(|((name, real, computes), level)| {
        let board = BOARDS.iter().find(|board| board.name == *name).expect("the board");
        let (_, emitted) = emitted.iter().find(|(of, _)| of == real).expect("the real type");
        let folder = object(board, emitted, level);
        let mut nm = Command::new("arm-none-eabi-nm");
        let output = nm.current_dir(folder.path()).args(["-u", "blocks.o"]).output().expect("nm starts");
        assert!(output.status.success(), "{name}, {real} {level}: nm fails");
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let undefined: Vec<&str> = text.split_whitespace().filter(|word| *word != "U").collect();
        let is_allowed = |name: &str| !computes && is_arithmetic(name);
        assert!(undefined.iter().all(|name| is_allowed(name)), "{name}, {real} {level}: {undefined:?}");
        // Without a floating-point unit there is no other way.
        assert!(*computes || !undefined.is_empty(), "{name}, {real} {level}: nothing is undefined");
    });
}

/// What the ABI of ARM names for arithmetic, not for copying memory, and what gcc calls to choose in a `switch` on a Cortex-M0.
pub fn is_arithmetic(name: &str) -> bool {
    let is_of_abi = name.starts_with("__aeabi_") && !name.starts_with("__aeabi_mem");
    is_of_abi || name.starts_with("__gnu_thumb1_case_")
}
