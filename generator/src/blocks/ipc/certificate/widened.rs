//! A program of single precision as one of double precision with the same numbers: the effect of its rounded coefficients,
//! without the roundings of its steps. Nothing is measured here.

use compiler::program::{Expr, Program, map_expressions};
use portable::{Literal, RealKind};
use std::borrow::Cow;

/// The program in double precision; unchanged if it is already in double precision.
pub(super) fn widened(program: &Program) -> Cow<'_, Program> {
    if program.real == RealKind::F64 {
        return Cow::Borrowed(program);
    }
    let mut wide = program.clone();
    wide.real = RealKind::F64;
    let variables = wide.inputs.iter_mut().chain(&mut wide.outputs).chain(&mut wide.state);
    variables.for_each(|variable| widen(&mut variable.start));
    wide.constants.iter_mut().for_each(|constant| widen(&mut constant.value));
    for list in [&mut wide.init, &mut wide.step] {
        map_expressions(list, &mut |expr| {
            expr.change(&mut |part| {
                if let Expr::Literal(literal) = part {
                    widen(literal);
                }
            });
        });
    }
    Cow::Owned(wide)
}

fn widen(literal: &mut Literal) {
    if let Literal::F32(value) = *literal {
        *literal = Literal::F64(value.into());
    }
}
