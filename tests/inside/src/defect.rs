//! Defects that a test plants, to see that they are found: in the programs of the harness, never in the product.

use compiler::program::{Expr, Program, Statement, map_expressions};
use portable::Binary;

/// A defect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defect {
    /// the interpreted program computes `b - a` for `a - b`
    InterpretedDifference,
    /// the printed program takes the wrong branch where there are two
    PrintedBranch,
}

/// All defects, with their names on the command line of a generated crate.
pub const DEFECTS: [(&str, Defect); 2] =
    [("interpreted-difference", Defect::InterpretedDifference), ("printed-branch", Defect::PrintedBranch)];

/// The name of a defect.
#[must_use]
pub fn name(defect: Defect) -> &'static str {
    DEFECTS.into_iter().find(|(_, known)| *known == defect).map_or("", |(name, _)| name)
}

/// The program that is interpreted last.
#[must_use]
pub fn interpreted(mut program: Program, defect: Option<Defect>) -> Program {
    if defect == Some(Defect::InterpretedDifference) {
        map_expressions(&mut program.step, &mut |expr| expr.change(&mut swap_difference));
    }
    program
}

/// The program that is printed.
#[must_use]
pub fn printed(mut program: Program, defect: Option<Defect>) -> Program {
    if defect == Some(Defect::PrintedBranch) {
        swap_branches(&mut program.step);
    }
    program
}

fn swap_difference(expr: &mut Expr) {
    if let Expr::Binary(Binary::Subtract, left, right) = expr {
        std::mem::swap(left, right);
    }
}

fn swap_branches(statements: &mut [Statement]) {
    for statement in statements {
        if let Statement::If { then, otherwise, .. } = statement {
            if !otherwise.is_empty() {
                std::mem::swap(then, otherwise);
            }
            swap_branches(then);
            swap_branches(otherwise);
        }
    }
}
