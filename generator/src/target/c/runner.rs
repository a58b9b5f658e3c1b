//! The runner of a block in C: a program for a user's own board, without the board's functions for printing and counting.

use super::exercise::{self, CExercise};
use super::names;
use crate::exercise::runner::Runner;
use crate::target::{BlockIdentity, File, TargetBlock, rendered};
use askama::Template;
use compiler::print::{Printer, c::LANGUAGE};
use portable::Literal;

#[derive(Template)]
#[template(path = "c/runner.c")]
struct CRunner<'a> {
    file: &'a str,
    axis: &'a BlockIdentity,
    block: &'static str,
    prefix: &'a str,
    runner: &'a Runner,
    exercise: CExercise<'a>,
    beyond: String,
    drill: Vec<(usize, usize, &'a str, String)>,
    turns: Vec<(&'a str, String)>,
}

pub(in crate::target) fn file(axis: &BlockIdentity, block: &TargetBlock<'_>, runner: &Runner) -> File {
    let (program, exercise) = (&*block.program, &*block.block.exercise);
    let prefix = names::prefix(axis, program.block);
    let file = format!("{prefix}_runner.c");
    let printer = &Printer::new(program, &LANGUAGE, &prefix);
    let setting = |at: usize, value: Literal| (block.input(&printer.names().inputs, at), (LANGUAGE.literal)(value));
    let drill = runner.drill(exercise).map(|turn| {
        let (input, value) = setting(turn.input, turn.value);
        (turn.samples.start, turn.samples.end, input, value)
    });
    let of = exercise::of(block, printer, (&format!("{prefix}_runner"), "&source->random"), &runner.expected);
    let template = CRunner {
        file: &file,
        axis,
        block: program.block,
        prefix: &prefix,
        runner,
        exercise: CExercise { draws: true, ..of },
        beyond: (LANGUAGE.literal)(exercise.beyond),
        drill: drill.collect(),
        turns: runner.turns.iter().map(|(at, value)| setting(*at, *value)).collect(),
    };
    rendered(&file, "", &template)
}
