//! Calls: inlined; borrowed parameters represent the caller's places.

use super::part::{Named, Part};
use super::{Frame, Specialiser};
use crate::arithmetic;
use crate::program::{Expr, Statement};
use portable::{Argument, Fn, Intrinsic, Literal, Mode, Param, Place, overlaid};
use std::rc::Rc;

impl Specialiser<'_> {
    /// Inlines a call that has a value.
    pub(super) fn called(&mut self, function: &'static Fn, arguments: &'static [Argument], name: &str) -> Expr {
        self.call(function, arguments, name).expect("specialise: a function that is used as a value has one")
    }

    /// Inlines a call; returns its value, if it has one. A local that holds the value gets the name.
    pub(super) fn call(&mut self, function: &'static Fn, arguments: &'static [Argument], name: &str) -> Option<Expr> {
        if let Some(intrinsic) = function.body.intrinsic {
            let operands = arguments.iter().map(|argument| self.value_argument(argument, function)).collect();
            return Some(self.intrinsic(intrinsic, operands));
        }
        let (cells, first_name) = (self.cells.len(), self.names.len());
        let mut context = None;
        for (param, argument) in function.params.iter().zip(arguments) {
            let (part, path) = self.passed(param, argument, function);
            context = context.or_else(|| path.clone());
            // The other arguments do not see the parameter.
            self.names.push(Named { name: "", part, path });
        }
        self.names[first_name..].iter_mut().zip(function.params).for_each(|(named, param)| named.name = param.name);
        let context = context.filter(|path| !path.is_empty() && *path != self.frame().context);
        if let Some(note) = context.as_ref().and_then(|path| self.notes.get(&**path)) {
            self.statements.push(Statement::Note(note.clone()));
        }
        let (context, first_round) = match context {
            // A separate path contains the number of the iteration.
            Some(path) => (path, self.rounds.len()),
            None => (Rc::clone(&self.frame().context), self.frame().first_round),
        };
        self.frames.push(Frame { first_name, context, first_round, function: function.name });
        let value = self.named_block(&function.body.block, name);
        self.frames.pop();
        self.names.truncate(first_name);
        self.cells.truncate(cells);
        value.map(|value| self.returned(function, value))
    }

    /// The part that a parameter represents; its path too, if it is more than a scalar and the function changes it.
    fn passed(&mut self, param: &Param, argument: &'static Argument, function: &Fn) -> (Part, Option<Rc<str>>) {
        match argument {
            Argument::Borrow { place } => {
                let part = self.place(place);
                let is_changed = param.mode == Mode::Mutable && part.cell().is_none();
                (part, if is_changed { self.path(place) } else { None })
            }
            Argument::Numbers { structure, part, numbers } => (self.with_numbers([structure, part, numbers]), None),
            Argument::Value { .. } => {
                let value = self.value_argument(argument, function);
                (self.bind(param.name, value), None)
            }
        }
    }

    /// The value of a call. A function without parameters is a named number. A bool, an index or a variant decides
    /// branches, and needs no name.
    fn returned(&mut self, function: &'static Fn, value: Expr) -> Expr {
        match value {
            Expr::Literal(literal @ (Literal::F64(_) | Literal::F32(_) | Literal::I32(_) | Literal::U32(_)))
                if function.params.is_empty() =>
            {
                self.named(function, literal)
            }
            value => value,
        }
    }

    /// An intrinsic: a comparison of known values and a conversion of an anonymous literal are folded.
    fn intrinsic(&self, intrinsic: Intrinsic, operands: Vec<Expr>) -> Expr {
        let known: Option<Vec<Literal>> = operands.iter().map(|operand| self.known(operand)).collect();
        let is_anonymous = operands.iter().all(|operand| matches!(operand, Expr::Literal(_)));
        match known {
            Some(known) if is_anonymous || matches!(intrinsic, Intrinsic::InRange | Intrinsic::Within) => {
                Expr::Literal(arithmetic::intrinsic(intrinsic, &known, self.program.real))
            }
            _ => Expr::Intrinsic(intrinsic, operands),
        }
    }

    /// A struct in whose part the scalars are replaced by those that another struct has, too.
    fn with_numbers(&mut self, places: [&'static Place; 3]) -> Part {
        let [structure, part, numbers] = places.map(|place| self.place(place));
        let mut cells = self.cells[structure.first..structure.first + structure.ty.leaves()].to_vec();
        let first = part.first - structure.first;
        overlaid(&part.ty, &numbers.ty, &mut |at, from| cells[first + at] = self.cells[numbers.first + from]);
        self.enter(structure.ty, cells.into_iter())
    }

    fn value_argument(&mut self, argument: &'static Argument, function: &Fn) -> Expr {
        let Argument::Value { value } = argument else {
            panic!("specialise: {} takes a scalar by value", function.name)
        };
        self.expr(value)
    }

    /// Binds a new name to a value. A value that can still change, or is computed, gets a local.
    pub(super) fn bind(&mut self, name: &str, value: Expr) -> Part {
        let cell = self.fixed(name, value);
        self.scalar(cell)
    }
}
