//! Traversal of statements and expressions, for every pass, the printer and the interpreter. No pass.

use super::{Arm, Expr, Statement, Var};

impl Statement {
    /// Calls `visit` for this statement, then for those inside it.
    pub(crate) fn walk<'a>(&'a self, visit: &mut impl FnMut(&'a Self)) {
        visit(self);
        match self {
            Self::Note(_) | Self::Assign { .. } => {}
            Self::If { then, otherwise, .. } => {
                then.iter().for_each(|inner| inner.walk(visit));
                otherwise.iter().for_each(|inner| inner.walk(visit));
            }
            Self::Choose { arms, .. } => arms.iter().flat_map(|arm| &arm.body).for_each(|inner| inner.walk(visit)),
            Self::Apart(body) => body.iter().for_each(|inner| inner.walk(visit)),
        }
    }

    /// The expression that the statement itself evaluates.
    pub(crate) fn expr(&self) -> Option<&Expr> {
        match self {
            Self::Note(_) | Self::Apart(_) => None,
            Self::Assign { value: expr, .. } | Self::If { condition: expr, .. } | Self::Choose { by: expr, .. } => {
                Some(expr)
            }
        }
    }

    /// Calls `visit` for every expression of this statement and of those inside it, as a whole.
    pub fn expressions<'a>(&'a self, visit: &mut impl FnMut(&'a Expr)) {
        self.walk(&mut |statement| statement.expr().into_iter().for_each(&mut *visit));
    }

    /// Calls `visit` for every variable that this statement or one inside it writes, with the expression.
    pub fn assignments<'a>(&'a self, visit: &mut impl FnMut(Var, &'a Expr)) {
        self.walk(&mut |statement| {
            if let Self::Assign { target, value } = statement {
                visit(*target, value);
            }
        });
    }

    /// Calls `visit` for each time that this statement or one inside it reads a variable.
    pub fn reads(&self, visit: &mut impl FnMut(Var)) {
        self.expressions(&mut |expr| expr.variables(visit));
    }

    /// Calls `visit` for each time that this statement or one inside it reads or writes a variable.
    pub(crate) fn variables(&self, visit: &mut impl FnMut(Var)) {
        self.walk(&mut |statement| {
            if let Self::Assign { target, .. } = statement {
                visit(*target);
            }
            statement.expr().into_iter().for_each(|expr| expr.variables(visit));
        });
    }

    /// Whether this statement or one inside it writes the variable.
    pub(crate) fn writes(&self, var: Var) -> bool {
        match self {
            Self::Assign { target, .. } => *target == var,
            outer => outer.branches().any(|list| list.iter().any(|inner| inner.writes(var))),
        }
    }

    /// Whether this statement or one inside it reads or writes the variable.
    pub fn mentions(&self, var: Var) -> bool {
        let is_asked = || self.expr().is_some_and(|expr| expr.mentions(var));
        match self {
            Self::Assign { target, .. } => *target == var || is_asked(),
            outer => is_asked() || outer.branches().any(|list| list.iter().any(|inner| inner.mentions(var))),
        }
    }

    /// The lists of an `if` or of a choice, or the separate one.
    pub(crate) fn branches(&self) -> impl Iterator<Item = &Vec<Self>> {
        let (first, second, arms): (_, _, &[Arm]) = match self {
            Self::If { then, otherwise, .. } => (Some(then), Some(otherwise), &[]),
            Self::Choose { arms, .. } => (None, None, arms),
            Self::Apart(body) => (Some(body), None, &[]),
            Self::Note(_) | Self::Assign { .. } => (None, None, &[]),
        };
        first.into_iter().chain(second).chain(arms.iter().map(|arm| &arm.body))
    }

    /// Calls `change` for each list of an `if` or of a choice, or for the separate one.
    pub(crate) fn change_branches(&mut self, mut change: impl FnMut(&mut Vec<Self>)) {
        match self {
            Self::Note(_) | Self::Assign { .. } => {}
            Self::If { then, otherwise, .. } => {
                change(then);
                change(otherwise);
            }
            Self::Choose { arms, .. } => arms.iter_mut().for_each(|arm| change(&mut arm.body)),
            Self::Apart(body) => change(body),
        }
    }
}

impl Expr {
    /// The operands of this expression.
    pub(crate) fn operands(&self) -> impl Iterator<Item = &Self> {
        let (first, second, more): (_, _, &[Self]) = match self {
            Self::Literal(_) | Self::Var(_) => (None, None, &[]),
            Self::Unary(_, operand) | Self::Element(_, operand) => (Some(&**operand), None, &[]),
            Self::Binary(_, left, right) => (Some(&**left), Some(&**right), &[]),
            Self::Intrinsic(_, operands) => (None, None, operands),
        };
        first.into_iter().chain(second).chain(more)
    }

    /// Calls `visit` for each operand of this expression.
    fn each_operand<'a>(&'a self, mut visit: impl FnMut(&'a Self)) {
        match self {
            Self::Literal(_) | Self::Var(_) => {}
            Self::Unary(_, operand) | Self::Element(_, operand) => visit(operand),
            Self::Binary(_, left, right) => {
                visit(left);
                visit(right);
            }
            Self::Intrinsic(_, operands) => operands.iter().for_each(visit),
        }
    }

    /// Calls `change` for each operand of this expression.
    pub(crate) fn change_operands(&mut self, mut change: impl FnMut(&mut Self)) {
        match self {
            Self::Literal(_) | Self::Var(_) => {}
            Self::Unary(_, operand) | Self::Element(_, operand) => change(operand),
            Self::Binary(_, left, right) => {
                change(left);
                change(right);
            }
            Self::Intrinsic(_, operands) => operands.iter_mut().for_each(change),
        }
    }

    /// Calls `visit` for the expression and for every part of it.
    pub fn parts<'a>(&'a self, visit: &mut impl FnMut(&'a Self)) {
        visit(self);
        self.each_operand(|operand| operand.parts(visit));
    }

    /// Calls `visit` for every variable that the expression reads.
    pub(crate) fn variables(&self, visit: &mut impl FnMut(Var)) {
        match self {
            Self::Var(var) => visit(*var),
            Self::Element(row, _) => row.elements().for_each(&mut *visit),
            _ => {}
        }
        self.each_operand(|operand| operand.variables(visit));
    }

    /// Whether the expression reads the variable.
    pub(crate) fn mentions(&self, var: Var) -> bool {
        match self {
            Self::Literal(_) => false,
            Self::Var(read) => *read == var,
            Self::Element(row, index) => index.mentions(var) || row.elements().any(|element| element == var),
            Self::Unary(_, operand) => operand.mentions(var),
            Self::Binary(_, left, right) => left.mentions(var) || right.mentions(var),
            Self::Intrinsic(_, operands) => operands.iter().any(|operand| operand.mentions(var)),
        }
    }

    /// Calls `change` for every part of the expression, inner parts first, and finally for the expression.
    pub fn change(&mut self, change: &mut impl FnMut(&mut Self)) {
        self.change_operands(|operand| operand.change(change));
        change(self);
    }
}

/// Calls `change` for every expression of the statements, each as a whole.
pub fn map_expressions(list: &mut [Statement], change: &mut impl FnMut(&mut Expr)) {
    change_each(list, &mut |expr, _| change(expr));
}

/// Calls `change` for every expression of the statements, with the variable to which it is assigned.
fn change_each(list: &mut [Statement], change: &mut impl FnMut(&mut Expr, Option<&mut Var>)) {
    for statement in list {
        match statement {
            Statement::Note(_) | Statement::Apart(_) => {}
            Statement::Assign { target, value } => change(value, Some(target)),
            Statement::If { condition: expr, .. } | Statement::Choose { by: expr, .. } => change(expr, None),
        }
        statement.change_branches(|list| change_each(list, change));
    }
}

/// Replaces every variable that the statements mention by another one.
pub(crate) fn rename(list: &mut [Statement], renamed: &impl Fn(Var) -> Var) {
    change_each(list, &mut |expr, target| {
        expr.change(&mut |part| {
            if let Expr::Var(var) = part {
                *var = renamed(*var);
            }
        });
        if let Some(target) = target {
            *target = renamed(*target);
        }
    });
}

/// Changes every statement in place and keeps those for which `change` returns true; those inside it come before it.
pub(crate) fn retain_mut(list: &mut Vec<Statement>, change: &mut impl FnMut(&mut Statement) -> bool) {
    list.retain_mut(|statement| {
        statement.change_branches(|list| retain_mut(list, change));
        change(statement)
    });
}

/// Leaves out an empty branch of an `if`; the first one is never empty then. Returns whether the statement does anything.
pub(crate) fn close_up(statement: &mut Statement, opposite: fn(Expr) -> Expr) -> bool {
    let Statement::If { condition, then, otherwise } = statement else { return true };
    let is_nothing = |list: &[Statement]| list.iter().all(|inner| matches!(inner, Statement::Note(_)));
    match (is_nothing(then), is_nothing(otherwise)) {
        (true, true) => return false,
        (true, false) => {
            *condition = opposite(std::mem::replace(condition, Expr::bool(true)));
            *then = std::mem::take(otherwise);
        }
        (false, true) => otherwise.clear(),
        (false, false) => {}
    }
    true
}
