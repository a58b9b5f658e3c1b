//! Options that change the bits, or might: each is refused, is caught by the self-test, or changes nothing. Which of them,
//! for every block, stands in the table.

use crate::{Tool, cases, is_measured, reference, tools};
use axgen_tests::cases::title;
use axgen_tests::environment::{by_depth, has_fma};
use golden::case::Case;
use golden::compare::compare;
use golden::engine::{Compiler, Failure, Harness};
use golden::samples::Samples;
use portable::RealKind;
use rayon::prelude::*;

/// What becomes of a block that is compiled with some options.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Outcome {
    /// it does not compile, and says why
    Refused,
    /// its self-test finds other bits
    Caught,
    /// it computes the reference's bits
    SameBits,
    /// it computes others, and nobody notices: a defect of the emitted guards
    Unnoticed(String),
    /// the compiler does not take the options
    NotTaken(String),
}

/// What has to become of every block.
#[derive(Clone, Copy, Debug)]
enum Expected {
    Refused,
    Caught,
    SameBits,
    /// caught in double precision; nothing changes in single precision
    CaughtInDouble,
    /// some blocks have an operation that the compiler moves, others have none
    CaughtOrSameBits,
}
use Expected::{Caught, CaughtInDouble, CaughtOrSameBits, Refused, SameBits};

/// A row of `flags.txt`: options for the emitted file, after `-std=c99 -O2`, and for linking.
struct Row {
    command: &'static str,
    options: Vec<&'static str>,
    link: Vec<&'static str>,
    expected: Expected,
}

fn table() -> Vec<Row> {
    let row = |line: &'static str| {
        let [command, options, link, expected] = line.split('|').map(str::trim).collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        let [options, link] = [options, link].map(|options| options.split_whitespace().collect());
        let expected = match expected {
            "refused" => Refused,
            "caught" => Caught,
            "same bits" => SameBits,
            "caught in f64" => CaughtInDouble,
            "caught or same bits" => CaughtOrSameBits,
            _ => panic!("{line}"),
        };
        Row { command, options, link, expected }
    };
    let rows: Vec<Row> = include_str!("flags.txt").lines().filter(|line| !line.starts_with('#')).map(row).collect();
    assert_eq!(rows.len(), 54);
    rows
}

/// What the stimulus of a case does, it has done in so many cycles.
const SAMPLES: usize = 20_000;

/// A case that is ready for every row of one compiler.
struct Ready {
    case: Case,
    inputs: Samples,
    expected: Samples,
    harness: Harness,
}

#[test]
#[expect(clippy::print_stdout, reason = "the table is a figure of the acceptance")]
fn options_that_change_bits_are_refused_or_caught() {
    let (table, mut mistakes) = (table(), Vec::new());
    for tool in tools() {
        let ready = ready(&tool);
        let is_measured = is_measured(&tool);
        // Each row has a part of the blocks in turn, each block a part of the rows.
        let part = by_depth(4, 30, 1);
        println!("\n{} behind `-std=c99 -O2`, {} blocks", tool.command, ready.len());
        let of_tool = table.iter().filter(|row| row.command == tool.command);
        for (number, row) in of_tool.enumerate() {
            let linked: &[&str] = if row.link.is_empty() { &[] } else { &["(linked with)"] };
            let options = [&row.options, linked, &row.link].concat().join(" ");
            if options.contains("-mfma") && !has_fma() {
                println!("  {options:<70} not run: this processor has no fused multiply-add");
                continue;
            }
            let in_turn = ready.iter().cycle().skip(number).step_by(part);
            let ready: Vec<&Ready> = in_turn.take(ready.len().div_ceil(part)).collect();
            let outcomes: Vec<Outcome> = ready.par_iter().map(|ready| outcome(ready, row)).collect();
            println!("  {options:<70} {}", summary(&outcomes));
            let judged =
                outcomes.iter().zip(&ready).filter(|(outcome, ready)| !is_right(outcome, row, ready, is_measured));
            mistakes.extend(judged.map(|(outcome, ready)| {
                format!("{} {options}: {}: {outcome:?} instead of {:?}", tool.command, title(&ready.case), row.expected)
            }));
        }
    }
    assert!(mistakes.is_empty(), "{mistakes:#?}");
}

fn ready(tool: &Tool) -> Vec<Ready> {
    let ready = |case: Case| {
        let (inputs, expected) = reference(&case, SAMPLES);
        let harness = Harness::compile(&case.axis, &case.block, &Compiler::new(tool.command, &[]));
        let harness = harness.unwrap_or_else(|failure| panic!("{}: {failure}", tool.command));
        Ready { case, inputs, expected, harness }
    };
    cases().into_par_iter().map(ready).collect()
}

fn outcome(ready: &Ready, row: &Row) -> Outcome {
    let compiler = Compiler::new(row.command, &[&["-O2"], &row.options[..]].concat()).linking(&row.link);
    match ready.harness.run(&ready.inputs, &compiler) {
        Err(Failure::Refused(_)) => Outcome::Refused,
        Err(Failure::SelfTest(_)) => Outcome::Caught,
        Err(failure) => Outcome::NotTaken(failure.to_string()),
        Ok(found) => match compare(&ready.expected, &found).first {
            None => Outcome::SameBits,
            Some(place) => Outcome::Unnoticed(format!("{place:?}")),
        },
    }
}

/// Whether an outcome is the row's. Of a compiler that the table was not made with, only that nothing goes unnoticed.
fn is_right(outcome: &Outcome, row: &Row, ready: &Ready, is_measured: bool) -> bool {
    match (outcome, row.expected) {
        (Outcome::Unnoticed(_), _) => false,
        _ if !is_measured => true,
        (Outcome::Refused, Refused) | (Outcome::Caught, Caught) | (Outcome::SameBits, SameBits) => true,
        (Outcome::Caught, CaughtInDouble) => ready.case.axis.axis.real == RealKind::F64,
        (Outcome::SameBits, CaughtInDouble) => ready.case.axis.axis.real == RealKind::F32,
        (Outcome::Caught | Outcome::SameBits, CaughtOrSameBits) => true,
        _ => false,
    }
}

fn summary(outcomes: &[Outcome]) -> String {
    let kinds = [
        ("refused", outcomes.iter().filter(|outcome| matches!(outcome, Outcome::Refused)).count()),
        ("caught by the self-test", outcomes.iter().filter(|outcome| matches!(outcome, Outcome::Caught)).count()),
        ("same bits", outcomes.iter().filter(|outcome| matches!(outcome, Outcome::SameBits)).count()),
        ("UNNOTICED", outcomes.iter().filter(|outcome| matches!(outcome, Outcome::Unnoticed(_))).count()),
        ("not taken", outcomes.iter().filter(|outcome| matches!(outcome, Outcome::NotTaken(_))).count()),
    ];
    let text = |(kind, count): &(&str, usize)| match *count {
        0 => None,
        count if count == outcomes.len() => Some((*kind).to_owned()),
        count => Some(format!("{kind}: {count}")),
    };
    kinds.iter().filter_map(text).collect::<Vec<_>>().join(", ")
}
