//! The Structured Text of a batch of programs, as the target `st` prints them, and the types of their signals.

use super::emit::{counts, samples};
use super::judge::Compiled;
use compiler::legalise::{self, WITH_DIGITS};
use compiler::print::st::PLAIN;
use compiler::print::{Appearance, Printer};
use compiler::program::{Expr, Program, Statement, Type, Var, Variable};
use std::fmt::Write;

/// A file of function blocks, and a line for each of them: its number, the names and types of its inputs, then of its
/// outputs, which are followed by the state.
#[derive(Default)]
pub struct Blocks {
    /// the Structured Text
    pub source: String,
    /// the lines
    pub signals: String,
    /// for each block how many runs and samples there are, then inputs and answers
    pub words: Vec<u64>,
}

impl Blocks {
    /// Adds a program under a number, unless it gives nothing: no target has such a block.
    pub fn add(&mut self, number: usize, program: &Program, compiled: &Compiled) {
        let whole = whole(program.clone(), compiled);
        let program = legalise::run(&whole, WITH_DIGITS).unwrap_or_else(|defect| panic!("{defect}"));
        if program.outputs.is_empty() {
            return;
        }
        let printer = Printer::new(&program, &PLAIN, "");
        let names = printer.names();
        let constants = program.constants.iter().zip(&names.constants).zip(printer.appearances());
        let assigned: Vec<_> = constants.filter(|(_, how)| **how == Appearance::Assigned).map(|(it, _)| it).collect();
        let mut text = format!("FUNCTION_BLOCK p{number}\n");
        let declared = |variables: &[Variable], names: &[String]| -> Vec<(String, Type)> {
            names.iter().cloned().zip(variables.iter().map(|variable| variable.ty)).collect()
        };
        let locals =
            program.locals.iter().map(|local| local.ty.expect("blocks: the typing pass has typed every local"));
        let mut inner = declared(&program.state, &names.state);
        inner.extend(names.locals.iter().cloned().zip(locals));
        inner.extend(assigned.iter().map(|(constant, name)| {
            ((*name).clone(), Type::of_literal(constant.value).expect("blocks: a constant exists at run time"))
        }));
        let (inputs, outputs) = (declared(&program.inputs, &names.inputs), declared(&program.outputs, &names.outputs));
        for (keyword, variables) in [("VAR_INPUT", &inputs), ("VAR_OUTPUT", &outputs), ("VAR", &inner)] {
            if !variables.is_empty() {
                let _ = writeln!(text, "{keyword}");
                for (name, ty) in variables {
                    let _ = writeln!(text, "    {name} : {};", PLAIN.ty(*ty, program.real));
                }
                text.push_str("END_VAR\n");
            }
        }
        for (constant, name) in assigned {
            let _ = writeln!(text, "{name} := {};", (PLAIN.operand)(constant.value).0);
        }
        let _ = writeln!(text, "{}END_FUNCTION_BLOCK\n", printer.body(&program.step, 0));
        let list = |signals: &[(String, Type)]| -> String {
            signals.iter().map(|(name, ty)| format!(" {name}:{ty:?}")).collect()
        };
        let _ = writeln!(self.signals, "{number};{};{}", list(&inputs), list(&outputs));
        self.source.push_str(&text);
        counts(compiled, &mut self.words);
        samples(compiled, &mut self.words);
    }
}

/// The program with its state as further outputs, and with an `init` that sets it: memory holds zeros in Structured Text, and other
/// values in the other engines.
fn whole(mut program: Program, compiled: &Compiled) -> Program {
    let outputs = program.outputs.len();
    let set = |(target, value)| Statement::Assign { target, value: Expr::Literal(value) };
    let state = compiled.unset.iter().enumerate().map(|(index, value)| (Var::State(index), *value));
    let mut init: Vec<Statement> = state.map(set).collect();
    init.append(&mut program.init);
    program.init = init;
    let show = |part| Statement::Assign { target: Var::Output(outputs + part), value: Expr::Var(Var::State(part)) };
    program.step.extend((0..program.state.len()).map(show));
    let shown = program.state.iter().map(|state| Variable { path: format!("shown.{}", state.path), ..state.clone() });
    program.outputs.extend(shown);
    program
}
