//! Moves parts of expressions into new locals, which are assigned before the statement. The calling pass selects the parts.

use crate::program::{Expr, Local, Program, Statement, Type, Var};

/// Assignments before a statement.
pub(super) struct Before<'p> {
    pub(super) program: &'p mut Program,
    statements: Vec<Statement>,
}

/// Calls `change` for every expression of a cycle; its assignments are inserted before the statement of the expression.
pub(super) fn run(mut program: Program, mut change: impl FnMut(&mut Expr, &mut Before<'_>)) -> Program {
    let mut step = std::mem::take(&mut program.step);
    let mut before = Before { program: &mut program, statements: Vec::new() };
    in_list(&mut step, &mut before, &mut change);
    Program { step, ..program }
}

fn in_list(list: &mut Vec<Statement>, before: &mut Before<'_>, change: &mut impl FnMut(&mut Expr, &mut Before<'_>)) {
    let mut at = 0;
    while at < list.len() {
        list[at].change_branches(|inner| in_list(inner, before, change));
        if let Statement::Assign { value: expr, .. } | Statement::If { condition: expr, .. } = &mut list[at] {
            change(expr, before);
        }
        let next = at + before.statements.len() + 1;
        if !before.statements.is_empty() {
            list.splice(at..at, before.statements.drain(..));
        }
        at = next;
    }
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
