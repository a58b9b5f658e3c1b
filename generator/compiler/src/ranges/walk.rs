//! Follows the statements of a program with the possible values of its variables, and collects properties that cannot be
//! proven.

use super::finding::{Finding, Kind};
use super::known::{Changes, Known, Place};
use super::real::{self, Interval};
use super::value::{Value, limits};
use super::whole::{self, Names, Whole};
use crate::arithmetic;
use crate::program::{Expr, Program, Statement, Type, Var};
use portable::{Binary, Intrinsic, Literal, Real, RealKind, Unary};

pub(super) struct Walk<'p> {
    pub program: &'p Program,
    pub known: Known,
    /// the position of the first input, output, state, constant and local
    first: [Place; 5],
    /// the present statement
    statement: Option<&'p Statement>,
    pub findings: Vec<Finding>,
    products: Vec<Product>,
    /// number of `if`s before this point of the text
    choices: usize,
    /// the `if`s with one answer only, by their number, and that answer
    pub decided: Vec<(usize, bool)>,
}

/// A local that is the product of a constant and a variable. The product with the opposite constant is its negation, exactly.
struct Product {
    local: (Place, u32),
    constant: f64,
    variable: (Place, u32),
}

impl<'p> Walk<'p> {
    /// The state before a body: inputs, outputs and state may contain any bit pattern.
    pub(super) fn new(program: &'p Program, names: Names) -> Self {
        let counts = [program.inputs.len(), program.outputs.len(), program.state.len(), program.constants.len()];
        let mut first = [0; 5];
        for (index, count) in counts.into_iter().enumerate() {
            first[index + 1] = first[index] + count;
        }
        let variables = program.inputs.iter().chain(&program.outputs).chain(&program.state);
        let variables = variables.map(|variable| Value::any(variable.ty));
        let constants = program.constants.iter().map(|constant| Value::one(constant.value, &names));
        let locals = program.locals.iter().map(|local| Value::any(local.ty.unwrap_or(Type::Real)));
        let values: Vec<Value> = variables.chain(constants).chain(locals).collect();
        let known = Known::new(values.into_iter(), first[4], names);
        let (findings, products, decided) = (Vec::new(), Vec::new(), Vec::new());
        Self { program, known, first, statement: None, findings, products, choices: 0, decided }
    }

    pub(super) fn place(&self, var: Var) -> Place {
        match var {
            Var::Input(index) => index,
            Var::Output(index) => self.first[1] + index,
            Var::State(index) => self.first[2] + index,
            Var::Constant(index) => self.first[3] + index,
            Var::Local(index) => self.first[4] + index,
        }
    }

    pub(super) fn list(&mut self, list: &'p [Statement]) {
        for statement in list {
            match statement {
                Statement::Note(_) => {}
                Statement::Assign { target, value } => {
                    self.statement = Some(statement);
                    self.check(value);
                    self.assign(*target, value);
                }
                Statement::If { condition, then, otherwise } => {
                    self.statement = Some(statement);
                    self.check(condition);
                    let mark = self.known.mark();
                    let choice = self.choices;
                    self.choices += 1;
                    let stays = guards(condition, then);
                    let branches = [(then, true), (otherwise, false)].map(|(branch, answer)| {
                        let mut is_reached = self.learn(condition, answer);
                        if !is_reached && stays {
                            // With what is known before the condition.
                            self.changes(mark, false);
                            is_reached = true;
                        }
                        if is_reached {
                            self.list(branch);
                        } else {
                            self.choices += choices(branch);
                        }
                        self.changes(mark, is_reached)
                    });
                    let is_decided = branches[0].is_some() != branches[1].is_some();
                    if is_decided && !self.selects(condition) {
                        self.decided.push((choice, branches[0].is_some()));
                    }
                    self.known.merge(branches);
                }
                Statement::Choose { .. } | Statement::Apart(_) => panic!("ranges: nothing has been legalised yet"),
            }
        }
    }

    /// Whether the condition asks for one number of several: a chain of such questions becomes an array or a choice, also where
    /// its last one has one answer only.
    fn selects(&self, condition: &Expr) -> bool {
        matches!(condition, Expr::Binary(Binary::Equal, left, _) if !matches!(left.ty(self.program), Type::Real | Type::Bool))
    }

    /// The changes since a mark, which are undone; `None` if the point cannot be reached.
    pub(super) fn changes(&mut self, mark: usize, is_reached: bool) -> Option<Changes> {
        let changes = self.known.take_back(mark);
        is_reached.then_some(changes)
    }

    fn assign(&mut self, target: Var, value: &Expr) {
        let source = match value {
            Expr::Var(var @ (Var::Input(_) | Var::Output(_) | Var::State(_) | Var::Local(_))) => Some(self.place(*var)),
            _ => None,
        };
        let is_asked = !matches!(value, Expr::Literal(_) | Expr::Var(_));
        let (found, follows) = if is_asked && value.ty(self.program) == Type::Bool {
            let mark = self.known.mark();
            let [no, yes] = [false, true].map(|answer| {
                let is_reached = self.learn(value, answer);
                self.changes(mark, is_reached)
            });
            let may_be = Value::Bool([no.is_some(), yes.is_some()]);
            (may_be, Some([no, yes].map(|changes| Known::facts(&changes.unwrap_or_default()))))
        } else {
            (self.value(value), None)
        };
        let place = self.place(target);
        self.known.assign(place, found, source, follows);
        if let (Var::Local(_), Some((constant, variable))) = (target, self.factors(value)) {
            self.products.push(Product { local: (place, self.known.written(place)), constant, variable });
        }
    }

    /// The constant and the variable of a product.
    fn factors(&self, expr: &Expr) -> Option<(f64, (Place, u32))> {
        let Expr::Binary(Binary::Multiply, left, right) = expr else { return None };
        let (constant, variable) = match (&**left, &**right) {
            (Expr::Var(Var::Constant(constant)), Expr::Var(variable))
            | (Expr::Var(variable), Expr::Var(Var::Constant(constant))) => (*constant, self.place(*variable)),
            _ => return None,
        };
        let constant = arithmetic::wide(self.program.constants[constant].value)?;
        Some((constant, (variable, self.known.written(variable))))
    }

    /// The range of a local that is a product, or of the negation of one.
    fn known_product(&self, expr: &Expr) -> Interval {
        let Some((constant, variable)) = self.factors(expr) else { return Interval::ANY };
        let is_same = |product: &&Product| {
            product.variable == variable
                && product.constant.abs().to_bits() == constant.abs().to_bits()
                && self.known.written(product.local.0) == product.local.1
        };
        let known = self.products.iter().filter(is_same).map(|product| {
            let Value::Real(interval) = self.known.value(product.local.0) else { return Interval::ANY };
            if product.constant.to_bits() == constant.to_bits() { interval } else { interval.negated() }
        });
        known.fold(Interval::ANY, Interval::meet)
    }

    pub(super) fn literal(&self, literal: Literal) -> Value {
        Value::one(literal, &self.known.names)
    }

    /// The possible values of an expression. An integer that leaves its type may have any value.
    pub(super) fn value(&self, expr: &Expr) -> Value {
        match expr {
            Expr::Literal(literal) => self.literal(*literal),
            Expr::Var(var) => self.known.value(self.place(*var)),
            Expr::Unary(Unary::Not, operand) => match self.value(operand) {
                Value::Bool([no, yes]) => Value::Bool([yes, no]),
                other => other,
            },
            Expr::Unary(Unary::Negate, operand) => match self.value(operand) {
                Value::Real(interval) => Value::Real(interval.negated()),
                Value::Whole(of) => within(Type::I32, Whole::numbers(-of.high, -of.low)),
                other => other,
            },
            Expr::Binary(operator, left, right) => match operator {
                Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide | Binary::Remainder => {
                    match (self.value(left), self.value(right)) {
                        (Value::Real(a), Value::Real(b)) => {
                            Value::Real(real::binary(*operator, a, b, self.program.real).meet(self.known_product(expr)))
                        }
                        (Value::Whole(a), Value::Whole(b)) => {
                            let ty = left.ty(self.program);
                            whole::binary(*operator, a, b).map_or(Value::any(ty), |result| within(ty, result))
                        }
                        (a, b) => panic!("ranges: {operator:?} of {a:?} and {b:?}"),
                    }
                }
                _ => Value::Bool([true; 2]),
            },
            Expr::Intrinsic(intrinsic, operands) => self.intrinsic(*intrinsic, operands),
            Expr::Element(..) => Value::any(expr.ty(self.program)),
        }
    }

    fn intrinsic(&self, intrinsic: Intrinsic, operands: &[Expr]) -> Value {
        match intrinsic {
            Intrinsic::InRange | Intrinsic::Within => Value::Bool([true; 2]),
            Intrinsic::FromU32 | Intrinsic::FromI32 => {
                let Whole { low, high, .. } = self.whole(&operands[0]);
                Value::Real(Interval::numbers(real_of(low, self.program.real), real_of(high, self.program.real)))
            }
            // A set, whose numbers the block that takes it checks.
            Intrinsic::Narrow => Value::Real(Interval::ANY),
            Intrinsic::Unsigned => match self.whole(&operands[0]) {
                Whole { low, .. } if low < 0 => Value::any(Type::U32),
                from_0_on => Value::Whole(from_0_on),
            },
            Intrinsic::Truncate | Intrinsic::Nearest => {
                let x = self.before_truncation(intrinsic, self.interval(&operands[0]));
                if is_convertible(x) {
                    Value::Whole(Whole::numbers(truncated(x.low), truncated(x.high)))
                } else {
                    Value::any(Type::I32)
                }
            }
        }
    }

    pub(super) fn interval(&self, expr: &Expr) -> Interval {
        match self.value(expr) {
            Value::Real(interval) => interval,
            other => panic!("ranges: {other:?} is not a real"),
        }
    }

    pub(super) fn whole(&self, expr: &Expr) -> Whole {
        match self.value(expr) {
            Value::Whole(whole) => whole,
            other => panic!("ranges: {other:?} is not an integer"),
        }
    }

    /// The value before truncation for the nearest integer: see the intrinsic.
    fn before_truncation(&self, intrinsic: Intrinsic, x: Interval) -> Interval {
        if intrinsic == Intrinsic::Truncate || !x.has_number() {
            return x;
        }
        let kind = self.program.real;
        let half = match kind {
            RealKind::F64 => portable::nearly_half::<f64>(),
            RealKind::F32 => portable::nearly_half::<f32>().into(),
        };
        let of = |x: f64| real::rounded(if x >= 0.0 { Binary::Add } else { Binary::Subtract }, x, half, kind);
        Interval { low: of(x.low), high: of(x.high), nan: x.nan }
    }

    /// Checks that each operation of an expression has a result on which all targets agree.
    fn check(&mut self, expr: &'p Expr) {
        expr.parts(&mut |part| self.check_operation(part));
    }

    fn check_operation(&mut self, part: &'p Expr) {
        match part {
            Expr::Unary(Unary::Negate, operand) if operand.ty(self.program) == Type::I32 => {
                let Whole { low, high, .. } = self.whole(operand);
                self.check_integer(Type::I32, Some(Whole::numbers(-high, -low)), part);
            }
            Expr::Binary(
                operator @ (Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide | Binary::Remainder),
                left,
                right,
            ) => {
                let ty = left.ty(self.program);
                if ty != Type::Real {
                    let result = whole::binary(*operator, self.whole(left), self.whole(right));
                    self.check_integer(ty, result, part);
                }
            }
            Expr::Intrinsic(intrinsic @ (Intrinsic::Truncate | Intrinsic::Nearest), operands) => {
                let x = self.interval(&operands[0]);
                if !is_convertible(self.before_truncation(*intrinsic, x)) {
                    self.find(Kind::Conversion(x), part);
                }
            }
            _ => {}
        }
    }

    fn check_integer(&mut self, ty: Type, result: Option<Whole>, part: &'p Expr) {
        let (low, high) = limits(ty);
        match result {
            None => self.find(Kind::Division, part),
            Some(result) if result.low < low || result.high > high => self.find(Kind::Overflow(result), part),
            Some(_) => {}
        }
    }

    fn find(&mut self, kind: Kind, part: &Expr) {
        self.findings.push(Finding::of(self.program, kind, part, self.statement));
    }
}

/// The result of an integer operation in a type, where it may have wrapped around.
fn within(ty: Type, result: Whole) -> Value {
    let (low, high) = limits(ty);
    if result.low < low || result.high > high { Value::any(ty) } else { Value::Whole(result) }
}

fn is_convertible(x: Interval) -> bool {
    !x.nan && (!x.has_number() || portable::is_within_i32(x.low) && portable::is_within_i32(x.high))
}

fn truncated(x: f64) -> i64 {
    x.truncated().into()
}

/// An integer as a real of that type.
fn real_of(number: i64, kind: RealKind) -> f64 {
    // Exact: it has at most 33 bits.
    let (high, low) = (number.div_euclid(1 << 16), number.rem_euclid(1 << 16));
    let [high, low] = [high, low].map(|half| f64::from_i32(i32::try_from(half).unwrap_or_default()));
    let number = high * 65_536.0 + low;
    match kind {
        RealKind::F64 => number,
        RealKind::F32 => f32::lit(number).into(),
    }
}

/// The number of `if`s in a list.
fn choices(list: &[Statement]) -> usize {
    let of = |statement: &Statement| statement.branches().map(|list| choices(list)).sum::<usize>();
    list.iter().map(|statement| of(statement) + usize::from(matches!(statement, Statement::If { .. }))).sum()
}

/// Whether the condition is the range test of a number that the branch converts. Both branches stay: other tools do not see
/// its answer.
fn guards(condition: &Expr, branch: &[Statement]) -> bool {
    let Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, tested) = condition else { return false };
    let Expr::Var(number) = tested[0] else { return false };
    branch.iter().any(|statement| match statement {
        Statement::Assign { value: Expr::Intrinsic(Intrinsic::Nearest | Intrinsic::Truncate, converted), .. } => {
            converted[0].mentions(number)
        }
        _ => false,
    })
}
