//! Moves parts of expressions into new locals, which are assigned before the statement. The calling pass selects the parts.

use crate::program::{Expr, Local, Program, Statement, Type, Var, rewrite};

/// Assignments before a statement.
pub(super) struct Before<'p> {
    pub(super) program: &'p mut Program,
    statements: Vec<Statement>,
}

/// Calls `change` for every expression of a cycle; its assignments are inserted before the statement of the expression.
pub(super) fn run(mut program: Program, mut change: impl FnMut(&mut Expr, &mut Before<'_>)) -> Program {
    let mut step = std::mem::take(&mut program.step);
    rewrite(&mut step, &mut |mut statement, list| {
        let mut before = Before { program: &mut program, statements: Vec::new() };
        if let Statement::Assign { value: expr, .. } | Statement::If { condition: expr, .. } = &mut statement {
            change(expr, &mut before);
        }
        list.append(&mut before.statements);
        list.push(statement);
    });
    Program { step, ..program }
}

impl Before<'_> {
    /// Moves an expression into a local, and replaces it by the local.
    pub(super) fn take(&mut self, expr: &mut Expr, path: String, ty: Type) {
        let target = Var::Local(self.program.locals.len());
        self.program.locals.push(Local { path, ty: Some(ty) });
        let value = std::mem::replace(expr, Expr::Var(target));
        self.statements.push(Statement::Assign { target, value });
    }
}
