//! A TcUnit suite for each block: the recorded run of the reference, and the test that compares it, bit by bit.

use super::{TESTS, guid, rendered, word_name};
use crate::render::{TcSuite, TcVector, Track};
use crate::target::outline::is_read;
use crate::target::st::block::origin;
use crate::target::{File, Header, Legal};
use compiler::print::number::bits;
use compiler::print::signals;
use compiler::print::st::{CODESYS, literal, type_name};
use compiler::program::{Type, Variable};
use portable::{Literal, RealKind};

/// The vector and the suite of a block.
pub(crate) fn files(axis: &Header, block: &Legal<'_>, name: &str) -> [File; 2] {
    let list = vector_name(name);
    let vector = &block.block.vector;
    let program = &block.block.program;
    let [input_names, output_names] = signals(program, &CODESYS);
    let tracks = |variables: &[Variable], names: &[String], samples: &[Vec<Literal>]| -> Vec<Track> {
        let track = |(index, variable): (usize, &Variable)| Track {
            name: names[index].clone(),
            ty: stored_as(variable.ty, axis.real),
            is_bits: variable.ty == Type::Real,
            values: values(samples.iter().map(|sample| sample[index]), axis.real),
        };
        variables.iter().enumerate().map(track).collect()
    };
    let all = tracks(&program.inputs, &input_names, &vector.inputs);
    let outputs = tracks(&program.outputs, &output_names, &vector.outputs);
    let inputs: Vec<Track> =
        all.into_iter().zip(is_read(program)).filter(|(_, read)| *read).map(|(track, _)| track).collect();
    let (vector_file, suite_file) = (format!("{list}.TcGVL"), format!("{}.TcPOU", suite_name(name)));
    let real = type_name(Type::Real, axis.real);
    let suite = TcSuite {
        origin: &origin(axis, &suite_file, &[]),
        id: &guid::derive("POU", &suite_name(name)),
        method_id: &guid::derive("Method", &suite_name(name)),
        name: &suite_name(name),
        block: name,
        vector: &list,
        samples: vector.inputs.len(),
        real,
        inputs: &inputs,
        outputs: &outputs,
    };
    let suite = rendered(TESTS, suite_file, &suite);
    let tracks: Vec<Track> = inputs.into_iter().chain(outputs).collect();
    let vector = TcVector {
        origin: &origin(axis, &vector_file, &[]),
        id: &guid::derive("GVL", &list),
        name: &list,
        last: vector.inputs.len() - 1,
        tracks: &tracks,
    };
    [rendered(TESTS, vector_file, &vector), suite]
}

/// The name of the suite of a function block.
pub(crate) fn suite_name(block: &str) -> String {
    format!("{block}_Test")
}

/// The name of the list with the vector of a function block.
pub(crate) fn vector_name(block: &str) -> String {
    format!("GVL_{}_vector", &block["FB_".len()..])
}

/// The type that the values of a signal have in a vector: reals as their bits.
fn stored_as(ty: Type, real: RealKind) -> &'static str {
    if ty == Type::Real { word_name(real) } else { type_name(ty, real) }
}

/// The values of a track, a run of equal ones as `count(value)`, in lines.
fn values(samples: impl Iterator<Item = Literal>, real: RealKind) -> String {
    let mut runs: Vec<(String, usize)> = Vec::new();
    for sample in samples {
        let text = match sample {
            Literal::F64(_) | Literal::F32(_) => word(sample, real),
            other => literal(other),
        };
        match runs.last_mut() {
            Some((last, count)) if *last == text => *count += 1,
            _ => runs.push((text, 1)),
        }
    }
    let mut lines = String::new();
    let mut line = 0;
    for (position, (text, count)) in runs.iter().enumerate() {
        let text = if *count > 1 { format!("{count}({text})") } else { text.clone() };
        if position > 0 {
            lines.push(',');
        }
        let breaks = line + text.len() > 100;
        lines.push_str(if position == 0 {
            ""
        } else if breaks {
            "\n        "
        } else {
            " "
        });
        line = if breaks { 0 } else { line + text.len() + 2 };
        lines.push_str(&text);
    }
    lines
}

/// The bits of a real as a literal.
fn word(value: Literal, real: RealKind) -> String {
    match real {
        RealKind::F64 => format!("16#{:016X}", bits(value)),
        RealKind::F32 => format!("16#{:08X}", bits(value)),
    }
}
