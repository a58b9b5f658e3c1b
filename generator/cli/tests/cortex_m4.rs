//! The example `examples/cortex-m4`: its script builds and runs it, and the block halves the vibration at least.

use std::{path::Path, process::Command};

/// Whether a plain run may go on without the programs that the example needs.
fn may_be_left_out() -> bool {
    ["CI", "AXGEN_EXHAUSTIVE"].iter().all(|variable| std::env::var_os(variable).is_none_or(|value| value.is_empty()))
}

#[test]
fn the_block_halves_the_vibration_of_the_simulated_axis() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/cortex-m4/run.sh");
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(script).arg(folder.path()).env("AXGEN", crate::AXGEN).output().unwrap();
    let [said, errors] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
    if output.status.code() == Some(3) && may_be_left_out() {
        eprintln!("NOT TESTED: {errors}");
        return;
    }
    assert!(output.status.success(), "{said}{errors}");
    // semihosting writes to standard error where standard output is not a terminal, in some versions
    let said = said + &errors;
    let line = said.lines().last().unwrap();
    let numbers: Vec<u32> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
    let [off, on] = numbers[..] else { panic!("{said}") };
    assert!(off > 500 && 2 * on < off, "{said}");
    assert_eq!(said.matches(" um/s #").count(), 16, "{said}");
}
