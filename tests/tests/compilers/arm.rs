//! Another processor: the emitted C on ARM, in an emulator. Only in an exhaustive run.

use crate::reference;
use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::{has, is_exhaustive};
use golden::compare::{Difference, compare};
use golden::engine::{Compiler, run_c};
use rayon::prelude::*;

const COMMAND: &str = "arm-linux-gnueabihf-gcc";
/// The second one has fused multiply-add, and is asked to use it.
const LEVELS: [&[&str]; 2] = [&["-O2"], &["-O3", "-mcpu=cortex-a7", "-mfpu=neon-vfpv4", "-ffp-contract=fast"]];
const SAMPLES: usize = 20_000;

#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn arm_gives_the_bits_of_the_reference() {
    if !is_exhaustive() {
        return;
    }
    let compiler_is_there = has(COMMAND, "Free Software Foundation", "gcc-arm-linux-gnueabihf libc6-dev-armhf-cross");
    assert!(compiler_is_there && has("qemu-arm", "qemu", "qemu-user"));
    let cases = in_both_real_types();
    cases.par_iter().for_each(|case| {
        let (inputs, expected) = reference(case, SAMPLES);
        for level in LEVELS {
            let compiler = Compiler::new(COMMAND, level).linking(&["-static"]).emulated(&["qemu-arm"]);
            let found = run_c(&case.axis, &case.block, &inputs, &compiler);
            let found = found.unwrap_or_else(|failure| panic!("{}: {level:?}: {failure}", title(case)));
            let difference = compare(&expected, &found);
            assert_eq!(difference, Difference { bits: 0, first: None }, "{}: {level:?}", title(case));
        }
    });
    println!("0 differing bits: {} blocks of {SAMPLES} samples with {COMMAND} at {LEVELS:?}", cases.len());
}
