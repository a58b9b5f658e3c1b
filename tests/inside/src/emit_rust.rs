//! The Rust of a batch of programs: one file for each real type. Its driver reads the words that the C's driver reads.

use super::emit::declared;
use compiler::print::Printer;
use compiler::print::rust::LANGUAGE;
use compiler::program::{Program, Statement, Type, Var, Variable};
use portable::RealKind;
use std::fmt::Write;

/// A file with all programs that were added.
#[derive(Default)]
pub struct Modules {
    source: String,
    calls: String,
}

impl Modules {
    /// Adds a program under a number.
    pub fn add(&mut self, number: usize, program: &Program) {
        self.source += &module(number, program);
        let _ = writeln!(self.calls, "    p{number}::run(words);");
    }

    /// The whole file, for programs of a real type.
    #[must_use]
    pub fn text(&self, real: RealKind) -> String {
        let (real, bits) = match real {
            RealKind::F64 => ("f64", "u64"),
            RealKind::F32 => ("f32", "u32"),
        };
        format!(
            "#![allow(warnings)]\ninclude!(\"driver.rs\");\ntype Real = {real};\ntype Bits = {bits};\n{}\nconst PROGRAMS: usize = {};\n\
             fn run_all(words: &mut File) {{\n{}}}\n",
            self.source,
            self.calls.lines().count(),
            self.calls
        )
    }
}

fn module(number: usize, program: &Program) -> String {
    let printer = Printer::new(program, &LANGUAGE, "");
    let names = printer.names();
    let body = |statements: &[Statement]| {
        let mut text = String::new();
        for (index, (constant, name)) in program.constants.iter().zip(&names.constants).enumerate() {
            if statements.iter().any(|statement| statement.mentions(Var::Constant(index))) {
                let ty = Type::of_literal(constant.value).expect("emit: a constant exists at run time");
                let (ty, value) = (LANGUAGE.ty(ty, program.real), (LANGUAGE.literal)(constant.value));
                let _ = writeln!(text, "    const {name}: {ty} = {value};");
            }
        }
        text + &printer.body(statements, 1)
    };
    format!(
        "/* program {number} */\nmod p{number} {{\nuse super::{{File, Found, Words, nearest}};\n{}{}{}\
         fn init(state: &mut State) {{\n{}}}\n\
         fn step(state: &mut State, inputs: &Inputs, outputs: &mut Outputs) {{\n{}}}\n\
         pub fn run(words: &mut File) {{\n    super::run({number}, words, init, step);\n}}\n}}\n",
        record("State", &program.state, &names.state, program.real),
        record("Inputs", &program.inputs, &names.inputs, program.real),
        record("Outputs", &program.outputs, &names.outputs, program.real),
        body(&program.init),
        body(&program.step),
    )
}

/// A struct that is read from words and compared with them.
fn record(name: &str, variables: &[Variable], names: &[String], real: RealKind) -> String {
    let (mut members, mut put, mut get) = (String::new(), String::new(), String::new());
    for (variable, member) in variables.iter().zip(names) {
        let ty = LANGUAGE.ty(variable.ty, real);
        let (read, bits) = match variable.ty {
            Type::Bool => ("words.next() != 0", format!("self.{member} as u64")),
            Type::I32 => ("words.next() as i32", format!("self.{member} as u32 as u64")),
            Type::U32 => ("words.next() as u32", format!("self.{member} as u64")),
            Type::Real => ("super::real(words.next())", format!("self.{member}.to_bits() as u64")),
        };
        let is_real = variable.ty == Type::Real;
        let _ = match declared(member, names) {
            Some((name, Some(length))) => writeln!(members, "    {name}: [{ty}; {length}],"),
            Some((name, None)) => writeln!(members, "    {name}: {ty},"),
            None => Ok(()),
        };
        let _ = writeln!(put, "        self.{member} = {read};");
        let _ = writeln!(get, "        found.push(({bits}, {is_real}, \"{}\"));", variable.path);
    }
    format!(
        "#[derive(Default)]\npub struct {name} {{\n{members}}}\nimpl Words for {name} {{\n    \
         fn put(&mut self, words: &mut File) {{\n{put}    }}\n    \
         fn get(&self, found: &mut Vec<Found>) {{\n{get}    }}\n}}\n"
    )
}
