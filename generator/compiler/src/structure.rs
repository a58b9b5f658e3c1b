//! What is in a program, as text: all but the values of its coefficients, the first values of its variables and the notes. Two programs
//! with the same text differ in such values only.

use crate::program::{Origin, Program, Statement, rewrite};
use portable::{Literal, RealKind};

/// The text. Before the passes a program has all that its stages ask for, whatever the values are.
pub fn of(program: &Program) -> String {
    let mut bare = program.clone();
    for constant in bare.constants.iter_mut().filter(|constant| matches!(constant.origin, Origin::Coefficient(_))) {
        constant.value = cleared(constant.value);
    }
    for variable in bare.inputs.iter_mut().chain(&mut bare.outputs).chain(&mut bare.state) {
        variable.start = cleared(variable.start);
    }
    for list in [&mut bare.init, &mut bare.step] {
        rewrite(list, &mut |statement, kept| {
            if !matches!(statement, Statement::Note(_)) {
                kept.push(statement);
            }
        });
    }
    let real = if bare.real == RealKind::F64 { "f64" } else { "f32" };
    format!("block    {}\nreal     {real}\n{bare}", bare.block)
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
