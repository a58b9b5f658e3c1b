//! The C of a batch of programs: one translation unit for each real type, and the words that its driver reads.

use super::judge::Compiled;
use compiler::print::c::LANGUAGE;
use compiler::print::{Printer, Scope};
use compiler::program::{Constant, Program, Statement, Type, Var, Variable};
use portable::Literal;
use std::fmt::Write;

/// A translation unit with its words.
#[derive(Default)]
pub struct Unit {
    /// the C, without the driver
    pub source: String,
    /// what the driver reads
    pub words: Vec<u64>,
    table: String,
}

impl Unit {
    /// Adds a program under a number. `program` is what is printed; the answers are those of `compiled`.
    pub fn add(&mut self, number: usize, program: &Program, compiled: &Compiled) {
        let source = source(number, program);
        self.source.push_str(&source);
        let _ = writeln!(self.table, "    {},", entry(number, program));
        let starts = program.outputs.iter().map(|variable| variable.start);
        counts(compiled, &mut self.words);
        self.words.extend(compiled.unset.iter().copied().chain(starts).map(word));
        samples(compiled, &mut self.words);
    }

    /// The whole unit.
    #[must_use]
    pub fn text(&self) -> String {
        format!("{}\nstatic const struct block blocks[] = {{\n{}    {{0}}\n}};\n", self.source, self.table)
    }
}

/// How many runs there are, and how many samples each has.
pub fn counts(compiled: &Compiled, words: &mut Vec<u64>) {
    words.push(compiled.inputs.len() as u64);
    words.push(compiled.inputs.first().map_or(0, Vec::len) as u64);
}

/// The inputs and the answer of each sample, run after run.
pub fn samples(compiled: &Compiled, words: &mut Vec<u64>) {
    for (inputs, answers) in compiled.inputs.iter().zip(&compiled.answers) {
        for (input, answer) in inputs.iter().zip(answers) {
            words.extend(input.iter().chain(answer).copied().map(word));
        }
    }
}

/// Types and functions of one program, and what the driver calls.
fn source(number: usize, program: &Program) -> String {
    let printer = Printer::new(program, &LANGUAGE, "block");
    let names = printer.names();
    let members = |variables: &[Variable], names: &[String]| -> String {
        if variables.is_empty() {
            return "    bool nothing;\n".to_owned();
        }
        let member = |(variable, name): (&Variable, &String)| {
            let (name, length) = declared(name, names)?;
            let length = length.map(|length| format!("[{length}]")).unwrap_or_default();
            Some(format!("    {} {name}{length};\n", LANGUAGE.ty(variable.ty, program.real)))
        };
        variables.iter().zip(names).filter_map(member).collect()
    };
    let body = |statements: &[Statement]| {
        let constants = program.constants.iter().zip(&names.constants).enumerate();
        let used = constants.filter(|(index, _)| mentions(statements, Var::Constant(*index)));
        let mut text: String = used.map(|(_, (constant, name))| named(constant, name, program)).collect();
        text.push_str(&printer.body(statements, 1));
        text
    };
    format!(
        "\n/* program {number} */\ntypedef struct {{\n{}}} s{number};\ntypedef struct {{\n{}}} i{number};\ntypedef struct {{\n{}}} o{number};\n\
         static void init{number}(s{number} *state)\n{{\n{}}}\n\
         static void step{number}(s{number} *restrict state, const i{number} *restrict inputs, \
         o{number} *restrict outputs)\n{{\n{}}}\n\
         static void call_init{number}(void *state) {{ init{number}(state); }}\n\
         static void call_step{number}(void *state, const void *inputs, void *outputs) \
         {{ step{number}(state, inputs, outputs); }}\n\
         static const struct leaf leaves{number}[] = {{{} {{0}}}};\n",
        members(&program.state, &names.state),
        members(&program.inputs, &names.inputs),
        members(&program.outputs, &names.outputs),
        body(&program.init),
        body(&program.step),
        leaves(number, program, names),
    )
}

/// The name with which a variable is declared, and the length of its array; `None` for an element that is not the first one.
pub fn declared<'n>(name: &'n str, names: &[String]) -> Option<(&'n str, Option<usize>)> {
    let Some((array, index)) = name.split_once('[') else { return Some((name, None)) };
    let length = names.iter().filter(|other| other.split_once('[').is_some_and(|(same, _)| same == array)).count();
    (index == "0]").then_some((array, Some(length)))
}

fn mentions(statements: &[Statement], var: Var) -> bool {
    statements.iter().any(|statement| statement.mentions(var))
}

fn named(constant: &Constant, name: &str, program: &Program) -> String {
    let ty = Type::of_literal(constant.value).expect("emit: a constant exists at run time");
    format!("    static const {} {name} = {};\n", LANGUAGE.ty(ty, program.real), (LANGUAGE.literal)(constant.value))
}

/// Where each scalar stands: state, then outputs, then inputs.
fn leaves(number: usize, program: &Program, names: &Scope) -> String {
    let mut text = String::new();
    for (prefix, variables, names) in [
        ("s", &program.state, &names.state),
        ("o", &program.outputs, &names.outputs),
        ("i", &program.inputs, &names.inputs),
    ] {
        for (variable, member) in variables.iter().zip(names) {
            let kind = match variable.ty {
                Type::Bool => 'b',
                Type::I32 => 'i',
                Type::U32 => 'u',
                Type::Real => 'r',
            };
            let _ = write!(text, " {{offsetof({prefix}{number}, {member}), '{kind}', \"{}\"}},", variable.path);
        }
    }
    text
}

/// The driver's entry: number, counts of scalars, sizes, functions.
fn entry(number: usize, program: &Program) -> String {
    let counts = [program.state.len(), program.outputs.len(), program.inputs.len()].map(|count| count.to_string());
    format!(
        "{{{number}, {}, sizeof(s{number}), sizeof(o{number}), sizeof(i{number}), leaves{number}, \
         call_init{number}, call_step{number}}}",
        counts.join(", ")
    )
}

/// A value as the driver reads it: its bits, or its number.
fn word(value: Literal) -> u64 {
    match value {
        Literal::F64(value) => value.to_bits(),
        Literal::F32(value) => u64::from(value.to_bits()),
        Literal::Bool(value) => u64::from(value),
        Literal::I32(value) => u64::from(value.cast_unsigned()),
        Literal::U32(value) => u64::from(value),
        Literal::Usize(_) | Literal::Variant(_) => panic!("emit: {value:?} is no value of a program"),
    }
}
