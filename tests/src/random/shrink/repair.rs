//! Makes a program whole again from which something was taken: what reads something that is gone becomes a constant, what
//! writes it goes too, and a name that comes into the sight of another of the same name is changed.

use crate::random::syntax::{
    Argument, Arm, Block, Call, Callee, Choice, Expr, Length, Place, Program, Scalar, Selection, Statement, Step, Type,
    Value,
};

/// The program, whole.
#[must_use]
pub fn program(mut program: Program) -> Program {
    for which in 0..program.functions.len() {
        let function = program.functions[which].clone();
        let names = function.params.iter().map(|param| (param.name.clone(), param.name.clone(), param.ty.clone()));
        let mut scope = Scope { program: &program, names: names.collect() };
        let body = scope.block(function.body);
        program.functions[which].body = body;
    }
    program
}

/// What is visible: the name before, the name now, the type.
struct Scope<'p> {
    program: &'p Program,
    names: Vec<(String, String, Type)>,
}

impl Scope<'_> {
    fn block(&mut self, block: Block) -> Block {
        let outer = self.names.len();
        let statements = block.statements.into_iter().filter_map(|statement| self.statement(statement)).collect();
        let value = block.value.map(|value| Box::new(self.expr(*value)));
        self.names.truncate(outer);
        Block { statements, value }
    }

    /// The statement, unless it has lost what it is there for.
    fn statement(&mut self, statement: Statement) -> Option<Statement> {
        Some(match statement {
            Statement::Let { name, mutable, value } => {
                let value = self.expr(value);
                let ty = type_of(&value);
                Statement::Let { name: self.enter(&name, ty), mutable, value }
            }
            Statement::Assign { place, value } => {
                let value = self.expr(value);
                Statement::Assign { place: self.place_of(place, value.scalar())?, value }
            }
            Statement::Compound { place, operator, value } => {
                let value = self.expr(value);
                Statement::Compound { place: self.place_of(place, value.scalar())?, operator, value }
            }
            Statement::For { variable, from, to, body } => {
                let (from, to) = (self.expr(from), self.expr(to));
                let outer = self.names.len();
                let variable = self.enter(&variable, Type::Scalar(Scalar::Usize));
                let body = self.block(body);
                self.names.truncate(outer);
                (!body.statements.is_empty()).then_some(Statement::For { variable, from, to, body })?
            }
            Statement::If(choice) => {
                let mut choice = self.choice(choice);
                choice.otherwise = choice.otherwise.filter(|otherwise| !otherwise.statements.is_empty());
                let something = !choice.then.statements.is_empty() || choice.otherwise.is_some();
                something.then_some(Statement::If(choice))?
            }
            Statement::Match(selection) => {
                let selection = self.selection(selection);
                let something = selection.arms.iter().any(|arm| !arm.body.statements.is_empty());
                something.then_some(Statement::Match(selection))?
            }
            Statement::Call(call) => Statement::Call(self.call(call)?),
        })
    }

    fn expr(&mut self, expr: Expr) -> Expr {
        match expr {
            Expr::Literal(value) => Expr::Literal(value),
            Expr::Read(place, scalar) => {
                let found = self.place_of(place, scalar);
                found.map_or(Expr::Literal(Value::plain(scalar)), |place| Expr::Read(place, scalar))
            }
            Expr::Unary(operator, operand) => Expr::Unary(operator, Box::new(self.expr(*operand))),
            Expr::Binary(operator, left, right) => {
                let left = self.expr(*left);
                Expr::Binary(operator, Box::new(left), Box::new(self.expr(*right)))
            }
            Expr::Call(call) => {
                let returns = call.returns;
                match (self.call(call), returns) {
                    (Some(call), _) => Expr::Call(call),
                    (None, returns) => Expr::Literal(Value::plain(returns.unwrap_or(Scalar::Bool))),
                }
            }
            Expr::If(choice) => Expr::If(Box::new(self.choice(*choice))),
            Expr::Match(selection) => Expr::Match(Box::new(self.selection(*selection))),
            Expr::Array(elements) => Expr::Array(elements.into_iter().map(|element| self.expr(element)).collect()),
            Expr::Repeat(element, length) => Expr::Repeat(Box::new(self.expr(*element)), length),
        }
    }

    fn choice(&mut self, choice: Choice) -> Choice {
        let condition = self.expr(choice.condition);
        let then = self.block(choice.then);
        Choice { condition, then, otherwise: choice.otherwise.map(|otherwise| self.block(otherwise)) }
    }

    fn selection(&mut self, selection: Selection) -> Selection {
        let scrutinee = self.expr(selection.scrutinee);
        let arm = |arm: Arm| Arm { patterns: arm.patterns, body: self.block(arm.body) };
        Selection { scrutinee, arms: selection.arms.into_iter().map(arm).collect() }
    }

    /// The call, if function and borrowed places are still there.
    fn call(&mut self, call: Call) -> Option<Call> {
        let program = self.program;
        let function = match call.callee {
            Callee::Function(which) if program.functions[which].removed => return None,
            Callee::Function(which) => Some(&program.functions[which]),
            Callee::Intrinsic(_) => None,
        };
        let mut arguments = Vec::new();
        for (position, argument) in call.arguments.into_iter().enumerate() {
            let wanted = function.map(|function| &function.params[position].ty);
            arguments.push(match argument {
                Argument::Value(value) => Argument::Value(self.expr(value)),
                Argument::Shared(place) => Argument::Shared(self.lent(place, wanted?)?),
                Argument::Mutable(place) => Argument::Mutable(self.lent(place, wanted?)?),
            });
        }
        Some(Call { arguments, ..call })
    }

    /// A place as it is called now, with its type.
    fn place(&mut self, place: Place) -> Option<(Place, Type)> {
        let (_, now, ty) = self.names.iter().rev().find(|(before, _, _)| *before == place.root)?.clone();
        let found = place.ty(&ty, self.program)?.clone();
        let step = |step| match step {
            Step::Index(index) => Step::Index(self.expr(index)),
            Step::Field(name) => Step::Field(name),
        };
        Some((Place { root: now, steps: place.steps.into_iter().map(step).collect() }, found))
    }

    fn place_of(&mut self, place: Place, scalar: Scalar) -> Option<Place> {
        self.place(place).filter(|(_, ty)| *ty == Type::Scalar(scalar)).map(|(place, _)| place)
    }

    fn lent(&mut self, place: Place, wanted: &Type) -> Option<Place> {
        self.place(place).filter(|(_, ty)| ty == wanted).map(|(place, _)| place)
    }

    /// Makes a name visible, under another one if it is taken.
    fn enter(&mut self, name: &str, ty: Type) -> String {
        let taken = |now: &str| self.names.iter().any(|(_, known, _)| known == now);
        let mut now = name.to_owned();
        let mut number = 2;
        while taken(&now) {
            now = format!("{name}_{number}");
            number += 1;
        }
        self.names.push((name.to_owned(), now.clone(), ty));
        now
    }
}

/// The type of what stands right of `let`.
fn type_of(value: &Expr) -> Type {
    let of =
        |element: &Expr, count| Type::Array(Box::new(Type::Scalar(element.scalar())), Length { count, named: None });
    match value {
        Expr::Array(elements) => of(&elements[0], elements.len()),
        Expr::Repeat(element, length) => of(element, length.count),
        scalar => Type::Scalar(scalar.scalar()),
    }
}
