//! What is in a program, as text: all but the values of its coefficients, the first values of its variables and the notes. Two programs
//! with the same text differ in such values only.

use crate::dump::Dump;
use crate::program::Program;
use portable::{Literal, RealKind};

/// The text. Before the passes a program has all that its stages ask for, whatever the values are.
pub fn of(program: &Program) -> String {
    let real = if program.real == RealKind::F64 { "f64" } else { "f32" };
    Dump::bare(program, cleared, format!("block    {}\nreal     {real}\n", program.block)).whole()
}

/// The value of this type that all have alike.
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
