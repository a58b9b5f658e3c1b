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

/// The value of this type that replaces all others.
fn cleared(value: Literal) -> Literal {
    match value {
        Literal::Bool(_) => Literal::Bool(false),
        Literal::I32(_) => Literal::I32(0),
        Literal::U32(_) => Literal::U32(0),
        Literal::F64(_) => Literal::F64(0.0),
        Literal::F32(_) => Literal::F32(0.0),
        Literal::Usize(_) | Literal::Variant(_) => value,
    }
}
