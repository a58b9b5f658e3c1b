//! Gives every real number that is an operand a name: its digits would be LREAL, and make a whole REAL expression LREAL.

use compiler::program::{Constant, Expr, Origin, Program, Var, map_expressions};
use portable::Literal;

/// The program with its numbers among the constants; one that is assigned as it is stays where it is.
#[must_use]
pub fn run(mut program: Program) -> Program {
    let first = program.constants.len();
    let mut constants = std::mem::take(&mut program.constants);
    program.step = map_expressions(std::mem::take(&mut program.step), &mut |expr| match expr {
        Expr::Literal(literal) => Expr::Literal(literal),
        other => other.map(&mut |part| match part {
            Expr::Literal(value @ (Literal::F64(_) | Literal::F32(_))) => {
                let known = constants[first..].iter().position(|constant| same_bits(constant.value, value));
                let position = known.unwrap_or_else(|| {
                    constants.push(named(constants.len() - first, value));
                    constants.len() - 1 - first
                });
                Expr::Var(Var::Constant(first + position))
            }
            part => part,
        }),
    });
    program.constants = constants;
    program
}

fn named(number: usize, value: Literal) -> Constant {
    Constant { path: format!("number[{number}]"), doc: "a number of the algorithm", value, origin: Origin::Function }
}

fn same_bits(left: Literal, right: Literal) -> bool {
    match (left, right) {
        (Literal::F64(left), Literal::F64(right)) => left.to_bits() == right.to_bits(),
        (Literal::F32(left), Literal::F32(right)) => left.to_bits() == right.to_bits(),
        _ => false,
    }
}
