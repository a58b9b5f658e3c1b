//! The engines `st`, `twincat`, `codesys` and `scl`: the emitted Structured Text, parsed with an independent grammar, and
//! run.

use super::{Failure, target};
use crate::samples::{Samples, Shape};
use compiler::legalise::{NOTICE, RENAMED};
use compiler::print::signals;
use compiler::print::st::PLAIN;
use compiler::program::{Program, Variable};
use generator::blocks::{Block, Designed};
use generator::target::{File, block_name};
use portable::Literal;
use st::{Dialect, Mistake, Signal};

/// Runs a block from the file that the target of a dialect emits.
pub(super) fn run(dialect: Dialect, designed: &Designed, block: &Block, inputs: &Samples) -> Result<Samples, Failure> {
    let [file, _] = files(dialect, designed, block)?;
    run_read(dialect, &read(dialect, &file, designed, block)?, block, inputs)
}

/// The file of a block in a dialect, and the file of its self-test.
///
/// # Errors
/// A defect of the target.
pub fn files(dialect: Dialect, designed: &Designed, block: &Block) -> Result<[File; 2], Failure> {
    let mut files = super::files(target(name(dialect)), designed, block)?.into_iter();
    match (files.next(), files.next()) {
        (Some(file), Some(test)) => Ok([file, test]),
        _ => Err(Failure::Broken("every target of Structured Text emits the block, then its self-test".to_owned())),
    }
}

/// Reads the block of a file.
///
/// # Errors
/// The text contains constructs that implementations may interpret differently.
pub fn read(dialect: Dialect, file: &File, designed: &Designed, block: &Block) -> Result<st::Block, Failure> {
    let (name, real) = (type_name(dialect, designed, block), block.program.real);
    if block.shares_set() {
        // The type of the sets is in the file of the block `ipc`.
        let taker = super::taker(designed)?;
        let [of_taker, _] = files(dialect, designed, &taker)?;
        let others = [read(dialect, &of_taker, designed, &taker)?];
        return st::Block::read_with(dialect, &file.text, &name, real, &others)
            .map_err(|mistakes| broken(&file.name, &mistakes));
    }
    let types = if dialect == Dialect::TwinCat { types(designed, block)? } else { None };
    let read = match types {
        Some(types) => st::Block::read_typed(&file.text, &types.text, &name, real),
        None => st::Block::read(dialect, &file.text, &name, real),
    };
    read.map_err(|mistakes| broken(&file.name, &mistakes))
}

/// The file with the type of the parameter sets of a block, which is separate in TwinCAT; `None` if it takes no sets.
///
/// # Errors
/// A defect of the target.
pub fn types(designed: &Designed, block: &Block) -> Result<Option<File>, Failure> {
    if !block.for_axis.program.has_set() {
        return Ok(None);
    }
    let files = super::files(target(name(Dialect::TwinCat)), designed, block)?;
    Ok(files.into_iter().find(|file| file.name.ends_with(".TcDUT")))
}

/// Runs a self-test to its end, or until a time limit; returns whether it reports its end, and the number of differing
/// values that it reports.
///
/// # Errors
/// The text contains constructs that implementations may interpret differently.
pub fn run_self_test(
    dialect: Dialect,
    (test, tested): (&File, &st::Block),
    designed: &Designed,
    block: &Block,
) -> Result<(bool, i32), Failure> {
    let name = format!("{}_self_test", type_name(dialect, designed, block));
    let others = std::slice::from_ref(tested);
    let read = st::Block::read_with(dialect, &test.text, &name, block.program.real, others);
    let read = read.map_err(|mistakes| broken(&test.name, &mistakes))?;
    let outputs = [("done", Literal::Bool(false)), ("differing", Literal::I32(0))];
    let mut instance = read.start(&[], &outputs, &[]).map_err(|mistakes| broken(&test.name, &mistakes))?;
    let mut results = Vec::new();
    for _ in block.trial_inputs() {
        instance.cycle(&[], &mut results);
    }
    match results[..] {
        [Literal::Bool(done), Literal::I32(differing)] => Ok((done, differing)),
        _ => Err(Failure::Broken(format!("{}: no sample", test.name))),
    }
}

/// Runs a block that was read.
///
/// # Errors
/// The text lacks a signal of the block, or compares a NaN, which stops some runtimes of TwinCAT and CODESYS.
pub fn run_read(dialect: Dialect, read: &st::Block, block: &Block, inputs: &Samples) -> Result<Samples, Failure> {
    let legal = target(name(dialect)).program(block).map_err(|defect| Failure::Broken(defect.to_string()))?;
    let (all, for_axis) = (&block.program, &block.for_axis);
    let [input_names, output_names] = names(&for_axis.program, &legal);
    let outputs = Shape::of(&for_axis.program.outputs, all.real);
    let inputs = inputs.only(&for_axis.inputs);
    let enable: &[(&str, bool)] = if dialect == Dialect::Plain { &[] } else { &[("Enable", true)] };
    let mut wanted = signals_of(&outputs, &output_names);
    // Some dialects have a separate output for an id without a fault.
    let has_notice = legal.outputs.iter().any(|output| output.path == NOTICE);
    wanted.extend(has_notice.then_some((NOTICE, Literal::U32(0))));
    let error_id = for_axis.program.outputs.iter().position(|output| output.path == "error_id");
    let mut instance = read
        .start(&signals_of(&inputs.shape, &input_names), &wanted, enable)
        .map_err(|mistakes| broken(all.block, &mistakes))?;
    let mut answers = Samples::with_capacity(outputs, inputs.len());
    let (mut values, mut results) = (Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        instance.cycle(&values, &mut results);
        if has_notice
            && let (Some(Literal::U32(notice)), Some(at)) = (results.pop(), error_id)
            && let Literal::U32(id) = &mut results[at]
        {
            // One of them is 0; otherwise the sum is not an id of the block.
            *id += notice;
        }
        if matches!(dialect, Dialect::TwinCat | Dialect::Codesys) && instance.has_compared_a_nan() {
            return Err(Failure::Broken(format!("{}: compares a NaN in sample {sample}", all.block)));
        }
        answers.push(&results);
    }
    Ok(answers.among(&for_axis.outputs, &Shape::of(&all.outputs, all.real)))
}

/// The target for the files of a dialect.
fn name(dialect: Dialect) -> &'static str {
    match dialect {
        Dialect::Plain => "st",
        Dialect::TwinCat => "twincat",
        Dialect::Codesys => "codesys",
        Dialect::Scl => "scl",
    }
}

/// The name of the function block in the text.
fn type_name(dialect: Dialect, designed: &Designed, block: &Block) -> String {
    let name = block_name(&designed.axis.name, block.program.block);
    if dialect == Dialect::Plain { name } else { format!("FB_{name}") }
}

/// The names of the axis's own signals in the text.
fn names(for_axis: &Program, legal: &Program) -> [Vec<String>; 2] {
    let [inputs, outputs] = signals(legal, &PLAIN);
    let named = |variables: &[Variable], legal: &[Variable], names: &[String]| -> Vec<String> {
        let renamed = |path: &str| RENAMED.iter().find(|(old, _)| *old == path).map_or("", |(_, new)| new);
        let position = |path: &str| legal.iter().position(|known| known.path == path || known.path == renamed(path));
        let name = |variable: &Variable| position(&variable.path).map_or_else(String::new, |at| names[at].clone());
        variables.iter().map(name).collect()
    };
    [named(&for_axis.inputs, &legal.inputs, &inputs), named(&for_axis.outputs, &legal.outputs, &outputs)]
}

fn broken(file: &str, mistakes: &[Mistake]) -> Failure {
    let lines: Vec<String> = mistakes.iter().map(|mistake| format!("{file}:{mistake}")).collect();
    Failure::Broken(lines.join("\n"))
}

/// The signals of a shape under their names in the text.
fn signals_of<'n>(shape: &Shape, names: &'n [String]) -> Vec<Signal<'n>> {
    shape.signals.iter().zip(names).map(|(signal, name)| (name.as_str(), signal.start)).collect()
}
