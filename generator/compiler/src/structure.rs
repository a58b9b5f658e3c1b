//! The structure of a program as text: everything except the values of its coefficients, the start values of its variables
//! and the notes. Programs with equal texts differ only in such values.

use crate::dump::Dump;
use crate::program::Program;
use portable::{Literal, RealKind};

/// The structure as text. Before the passes a program contains everything that its stages require, for any values.
pub fn of(program: &Program) -> String {
    let real = if program.real == RealKind::F64 { "f64" } else { "f32" };
    Dump::bare(program, cleared, format!("block    {}\nreal     {real}\n", program.block)).whole()
}

/// The text for all values of this type.
fn cleared(value: Literal) -> &'static str {
    match value {
        Literal::Bool(_) => "false",
        Literal::I32(_) | Literal::U32(_) => "0",
        Literal::F64(_) | Literal::F32(_) => "0.0",
        Literal::Usize(_) | Literal::Variant(_) => panic!("structure: {value:?} does not exist at run time"),
    }
}
