//! The emitted runners: on every processor the bits of the reference, subnormal numbers flushed or not; and what a runner says of a
//! block that differs.

use crate::boards::{BOARDS, Board, Build, Emitted, run_here};
use axgen_tests::cases::{all, in_both_real_types, title};
use axgen_tests::environment::{is_every_level, is_exhaustive};
use generator::target::File;
use golden::case::Case;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// The blocks that contain the others: every kind of stage; feedforward and position control; a spindle.
const BLOCKS: [&str; 3] = ["three-full-stages", "axis-in-the-cnc", "whole-spindle-in-the-cnc"];
/// One period of the stimulus: all that it does.
const PERIOD: usize = 20_000;
/// Of every case, each on one processor.
const SHORT: usize = 5_000;

/// What a runner prints that finds no difference, without a counter.
fn passed(prefix: &str, samples: usize) -> String {
    let digests = samples.div_ceil(1000);
    format!(
        "{prefix}: {samples} samples\nself-test: passed\ndigests of 1000 samples that differ: 0 of {digests}\n\
         cycles of step: no counter\npassed\n"
    )
}

/// The runners of the three blocks in one real type: `f32` or `f64`.
pub fn blocks(real: &str) -> Vec<Emitted> {
    let cases = in_both_real_types();
    let case = |name: &&str| {
        let is_it = |case: &&Case| title(case) == format!("{name}, {real}");
        cases.iter().find(is_it).unwrap_or_else(|| panic!("no case {name}, {real}"))
    };
    BLOCKS.iter().map(case).map(|case| Emitted::of(&case.axis, &case.block, PERIOD)).collect()
}

/// The boards of this run: in a plain run one, if it is there.
fn boards() -> Vec<Board> {
    let is_run = |board: &Board| (is_exhaustive() || board.name == "Cortex-M4F") && board.is_there();
    BOARDS.into_iter().filter(is_run).collect()
}

/// What a counter says is not compared: AArch64 has one in the emulator too.
fn without_counter(text: &str) -> String {
    let line = |line: &str| match line.starts_with("cycles of step: ") {
        true => "cycles of step: no counter\n".to_owned(),
        false => line.to_owned() + "\n",
    };
    text.lines().map(line).collect()
}

#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn every_processor_gives_the_bits_of_the_reference() {
    let boards = boards();
    let kinds = if is_exhaustive() { &["f64", "f32"][..] } else { &["f32"] };
    let emitted: Vec<_> = kinds.iter().map(|kind| (*kind, blocks(kind))).collect();
    let ways = boards.iter().flat_map(|board| [false, true].map(|flush| (board, flush)));
    let ways = ways.filter(|(board, flush)| board.flushes || !flush);
    let runs: Vec<_> = ways.flat_map(|(board, flush)| emitted.iter().map(move |of| (board, flush, of))).collect();
    runs.par_iter().for_each(|(board, flush, (real, emitted))| {
        let emitted: Vec<&Emitted> = emitted.iter().collect();
        let options: &[&str] = if *flush { &["-DFLUSH"] } else { &[] };
        let said = board.run(&emitted, Build { options, ..Build::default() });
        let expected: String = emitted.iter().map(|of| passed(&of.prefix, PERIOD)).collect();
        assert_eq!(without_counter(&said), expected, "{}, {real}, flush {flush}", board.name);
    });
    let names: Vec<&str> = boards.iter().map(|board| board.name).collect();
    println!(
        "0 differing bits: {} programs of {} blocks with {PERIOD} samples each on {}",
        runs.len(),
        BLOCKS.len(),
        names.join(", ")
    );
}

/// Every eighth block of the golden cases, in both real types, each on one of the processors; all with `AXGEN_EVERY_LEVEL`.
#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn every_case_gives_the_bits_of_the_reference_on_some_processor() {
    if !is_exhaustive() {
        return;
    }
    let boards = boards();
    let mut seen = BTreeSet::new();
    let emitted =
        in_both_real_types().into_iter().map(|case| (title(&case), Emitted::of(&case.axis, &case.block, SHORT)));
    // Cases of one block that differ in their stimulus only have the same files.
    let emitted: Vec<_> = emitted.filter(|(_, of)| seen.insert(of.files[1].text.clone())).collect();
    let part = if is_every_level() { 1 } else { 8 };
    emitted.par_iter().step_by(part).enumerate().for_each(|(number, (title, emitted))| {
        let board = &boards[number % boards.len()];
        let said = board.run(&[emitted], Build::default());
        assert_eq!(without_counter(&said), passed(&emitted.prefix, SHORT), "{title}, {}", board.name);
    });
    println!("0 differing bits: {} blocks of {SHORT} samples", emitted.len().div_ceil(part));
}

/// With a counter of the board that counts one instruction as 32 ns of a clock of 25 MHz.
#[test]
fn a_runner_counts_cycles() {
    let case = all().into_iter().find(|case| title(case) == "single-precision, f32").expect("the case");
    let emitted = Emitted::of(&case.axis, &case.block, PERIOD);
    let board = &BOARDS[2];
    if !board.is_there() {
        return;
    }
    let build = Build { options: &["-DRUNNER_CYCLES"], emulator: &["-icount", "shift=5"] };
    let said = board.run(&[&emitted], build);
    let line = said.lines().find_map(|line| line.strip_prefix("cycles of step: ")).expect("a line with cycles");
    let numbers: Vec<u32> = line.split([' ', ',']).filter_map(|word| word.parse().ok()).collect();
    let [least, mean, most, at] = numbers[..] else { panic!("{said}") };
    assert!(0 < least && least <= mean && mean <= most && most < 2000, "{said}");
    assert!((at as usize) < PERIOD && said.ends_with("\npassed\n"), "{said}");
}

/// Another digest stands in a runner: it says where, and counts.
#[test]
fn a_runner_names_the_first_samples_that_differ() {
    let case = all().into_iter().find(|case| title(case) == "single-precision, f32").expect("the case");
    let mut emitted = Emitted::of(&case.axis, &case.block, 2500);
    let File { text, .. } = emitted.files.last_mut().expect("the runner");
    let digests: Vec<String> = text.split("UINT32_C(0x").skip(1).take(3).map(|rest| rest[..8].to_owned()).collect();
    *text = text.replace(&digests[1], "00000000").replace(&digests[2], "00000000");
    let said = run_here(&[&emitted]);
    let (prefix, digest) = (&emitted.prefix, &digests[1]);
    let expected = format!(
        "{prefix}: 2500 samples\nself-test: passed\ndigests of 1000 samples that differ: 2 of 3\n\
         first in samples 1000 to 1999: {digest}, the reference 00000000\ncycles of step: no counter\nFAILED\n"
    );
    assert_eq!(without_counter(&said), expected);
}

/// Another constant stands in a block: its self-test differs, and the runner's digests do.
#[test]
fn a_runner_finds_another_constant() {
    let case = all().into_iter().find(|case| title(case) == "single-precision, f32").expect("the case");
    let mut emitted = Emitted::of(&case.axis, &case.block, 2500);
    let file = emitted.files.iter_mut().find(|file| file.text.contains("bandpass0_a = ")).expect("the source");
    let line = file.text.lines().find(|line| line.contains("bandpass0_a = ")).expect("a constant").to_owned();
    let digit = line.find('.').expect("a decimal point") + 6;
    let other = if line.as_bytes()[digit] == b'1' { "2" } else { "1" };
    let changed = [&line[..digit], other, &line[digit + 1..]].concat();
    file.text = file.text.replace(&line, &changed);
    let said = run_here(&[&emitted]);
    assert!(
        said.contains("differs\n") && said.contains("that differ: 3 of 3\n") && said.ends_with("FAILED\n"),
        "{said}"
    );
}
