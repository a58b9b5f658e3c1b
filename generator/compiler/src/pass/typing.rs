//! Determines the type of every local, from the bottom up, and checks that each operator fits its operands.

use super::Defect;
use crate::program::{Expr, Program, Statement, Type, Var};
use portable::{Binary, Intrinsic, Literal, Unary};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let (init, step) = (std::mem::take(&mut program.init), std::mem::take(&mut program.step));
    type_statements(&init, &mut program)?;
    type_statements(&step, &mut program)?;
    Ok(Program { init, step, ..program })
}

fn type_statements(statements: &[Statement], program: &mut Program) -> Result<(), Defect> {
    for statement in statements {
        match statement {
            Statement::Note(_) => {}
            Statement::Assign { target, value } => {
                let found = type_of(value, program)?;
                let declared = match *target {
                    Var::Local(local) => *program.locals[local].ty.get_or_insert(found),
                    var => variable_type(var, program)?,
                };
                expect(declared, found, value)?;
            }
            Statement::If { condition, then, otherwise } => {
                expect(Type::Bool, type_of(condition, program)?, condition)?;
                type_statements(then, program)?;
                type_statements(otherwise, program)?;
            }
            Statement::Apart(body) => type_statements(body, program)?,
            Statement::Choose { by, arms } => {
                let found = type_of(by, program)?;
                for arm in arms {
                    arm.labels.iter().try_for_each(|label| expect(type_of(label, program)?, found, by))?;
                    type_statements(&arm.body, program)?;
                }
            }
        }
    }
    Ok(())
}

/// The type of an expression whose locals are typed.
fn type_of(expr: &Expr, program: &Program) -> Result<Type, Defect> {
    match expr {
        Expr::Literal(literal) => {
            Type::of_literal(*literal).ok_or_else(|| defect(format!("{literal:?} is left at run time")))
        }
        Expr::Var(var) => variable_type(*var, program),
        Expr::Unary(operator, operand) => {
            let found = type_of(operand, program)?;
            match (operator, found) {
                (Unary::Not, Type::Bool) | (Unary::Negate, Type::Real | Type::I32) => Ok(found),
                _ => Err(defect(format!("{operator:?} of {found:?} in {expr:?}"))),
            }
        }
        Expr::Binary(operator, left, right) => type_of_binary(expr, *operator, [left, right], program),
        Expr::Intrinsic(intrinsic, operands) => {
            let takes = match intrinsic {
                Intrinsic::FromU32 => Type::U32,
                Intrinsic::FromI32 | Intrinsic::Unsigned => Type::I32,
                _ => Type::Real,
            };
            operands.iter().try_for_each(|operand| expect(takes, type_of(operand, program)?, operand))?;
            Ok(Type::of_intrinsic(*intrinsic))
        }
        Expr::Element(row, index) => {
            expect(Type::U32, type_of(index, program)?, index)?;
            let mut types = row.elements().map(|element| variable_type(element, program));
            let first = types.next().unwrap_or_else(|| Err(defect("an array without elements".to_owned())))?;
            types.try_for_each(|ty| expect(first, ty?, expr)).map(|()| first)
        }
    }
}

fn type_of_binary(expr: &Expr, operator: Binary, [left, right]: [&Expr; 2], program: &Program) -> Result<Type, Defect> {
    let found = type_of(left, program)?;
    expect(found, type_of(right, program)?, right)?;
    let is_division = matches!(operator, Binary::Divide | Binary::Remainder) && found != Type::Real;
    if is_division && !is_from_one(right) {
        return Err(defect(format!("{operator:?} of {found:?} by no number from 1 on in {expr:?}")));
    }
    // Reals may be compared with 0 for equality.
    if operator == Binary::Equal && right.is_zero(&program.constants) {
        return Ok(Type::Bool);
    }
    binary_type(operator, found).ok_or_else(|| defect(format!("{operator:?} of {found:?} in {expr:?}")))
}

fn is_from_one(divisor: &Expr) -> bool {
    match divisor {
        Expr::Literal(Literal::I32(divisor)) => *divisor > 0,
        Expr::Literal(Literal::U32(divisor)) => *divisor > 0,
        _ => false,
    }
}

fn binary_type(operator: Binary, operand: Type) -> Option<Type> {
    match (operator, operand) {
        (Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide, Type::Real | Type::I32 | Type::U32)
        | (Binary::Remainder, Type::I32 | Type::U32)
        | (Binary::And | Binary::Or, Type::Bool) => Some(operand),
        (Binary::Less | Binary::LessEqual | Binary::Greater | Binary::GreaterEqual, ty) if ty != Type::Bool => {
            Some(Type::Bool)
        }
        // Reals are compared by order, or with 0: a comparison of two reals for equality is almost always an error.
        (Binary::Equal | Binary::NotEqual, ty) if ty != Type::Real => Some(Type::Bool),
        _ => None,
    }
}

fn variable_type(var: Var, program: &Program) -> Result<Type, Defect> {
    program.ty(var).ok_or_else(|| match var {
        Var::Local(index) => defect(format!("`{}` is read before it is assigned", program.locals[index].path)),
        _ => defect(format!("{var:?} does not exist at run time")),
    })
}

fn expect(wanted: Type, found: Type, expr: &Expr) -> Result<(), Defect> {
    if wanted == found {
        return Ok(());
    }
    Err(defect(format!("{wanted:?} wanted, {found:?} found in {expr:?}")))
}

fn defect(message: String) -> Defect {
    Defect { pass: "typing", message }
}
