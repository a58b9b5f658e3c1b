//! A TcUnit suite for each block: the recorded run of the reference, and the test that compares it, bit by bit.

use super::{PREFIX, TESTS, guid, rendered, word_name};
use crate::target::outline::is_read;
use crate::target::st::{Origin, origin};
use crate::target::{File, Header, Legal};
use askama::Template;
use compiler::print::signals;
use compiler::print::st::{CODESYS, literal};
use compiler::program::{Type, Variable};
use portable::Literal;

/// The suite that runs a block with its vector.
#[derive(Template)]
#[template(path = "twincat/suite.TcPOU")]
struct TcSuite<'a> {
    origin: Origin<'a>,
    id: String,
    method_id: String,
    name: &'a str,
    block: &'a str,
    vector: &'a str,
    samples: usize,
    real: &'a str,
    /// what is read from the vector
    inputs: Vec<Track>,
    /// what is compared with it
    outputs: Vec<Track>,
}

/// A recorded run of a block.
#[derive(Template)]
#[template(path = "twincat/vector.TcGVL")]
struct TcVector<'a> {
    origin: Origin<'a>,
    id: String,
    suite: &'a TcSuite<'a>,
}

/// A signal of a recorded run.
struct Track {
    name: String,
    /// the type of its values: reals as their bits
    ty: &'static str,
    /// whether the values are the bits of reals
    is_bits: bool,
    values: String,
}

/// The vector and the suite of a block.
pub(crate) fn files(axis: &Header, block: &Legal<'_>, name: &str) -> [File; 2] {
    let vector = &block.block.vector;
    let program = &block.block.program;
    let [input_names, output_names] = signals(program, &CODESYS);
    let track = |index: usize, variable: &Variable, names: &[String], samples: &[Vec<Literal>]| Track {
        name: names[index].clone(),
        ty: if variable.ty == Type::Real { word_name(axis.real) } else { CODESYS.ty(variable.ty, axis.real) },
        is_bits: variable.ty == Type::Real,
        values: values(&samples.iter().map(|sample| sample[index]).collect::<Vec<_>>()),
    };
    let inputs = program.inputs.iter().zip(is_read(program)).enumerate().filter(|(_, (_, is_read))| *is_read);
    let outputs = program.outputs.iter().enumerate();
    let (list, suite) = (vector_name(name), suite_name(name));
    let (vector_file, suite_file) = (format!("{list}.TcGVL"), format!("{suite}.TcPOU"));
    let suite = TcSuite {
        origin: origin(axis, &suite_file, &[]),
        id: guid("POU", &suite),
        method_id: guid("Method", &suite),
        name: &suite,
        block: name,
        vector: &list,
        samples: vector.inputs.len(),
        real: CODESYS.ty(Type::Real, axis.real),
        inputs: inputs.map(|(index, (variable, _))| track(index, variable, &input_names, &vector.inputs)).collect(),
        outputs: outputs.map(|(index, variable)| track(index, variable, &output_names, &vector.outputs)).collect(),
    };
    let vector = TcVector { origin: origin(axis, &vector_file, &[]), id: guid("GVL", &list), suite: &suite };
    [rendered(TESTS, &vector_file, &vector), rendered(TESTS, &suite_file, &suite)]
}

/// The name of the suite of a function block.
pub(crate) fn suite_name(block: &str) -> String {
    format!("{block}_Test")
}

/// The name of the list with the vector of a function block.
pub(crate) fn vector_name(block: &str) -> String {
    format!("GVL_{}_vector", &block[PREFIX.len()..])
}

/// The values of a track, a run of equal ones as `count(value)`, in lines. Reals are their bits.
fn values(samples: &[Literal]) -> String {
    let (mut lines, mut line) = (String::new(), 0);
    for run in samples.chunk_by(|a, b| a == b) {
        let value = match run[0] {
            Literal::F64(value) => format!("16#{:016X}", value.to_bits()),
            Literal::F32(value) => format!("16#{:08X}", value.to_bits()),
            other => literal(other),
        };
        let text = if run.len() > 1 { format!("{}({value})", run.len()) } else { value };
        let breaks = line + text.len() > 100;
        if !lines.is_empty() {
            lines.push_str(if breaks { ",\n        " } else { ", " });
        }
        line = if breaks { 0 } else { line + text.len() + 2 };
        lines.push_str(&text);
    }
    lines
}
