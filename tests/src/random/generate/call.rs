//! Random calls: which function fits, and what it is called with.

use super::scope::Writer;
use crate::random::syntax::{Argument, Call, Callee, Function, Mode, Param, Scalar, Type};

impl Writer<'_> {
    /// A call without effect that gives a value of a type: it may stand inside an expression.
    pub fn pure_call(&mut self, scalar: Scalar) -> Option<Call> {
        self.call(|function| !function.mutates() && function.returns == Some(scalar))
    }

    /// A call that gives a value of a type, with or without an effect: it stands alone.
    pub fn call_for(&mut self, scalar: Scalar) -> Option<Call> {
        self.call(|function| function.returns == Some(scalar))
    }

    /// A call with an effect that gives a value of a type.
    pub fn mutating_call_for(&mut self, scalar: Scalar) -> Option<Call> {
        self.call(|function| function.mutates() && function.returns == Some(scalar))
    }

    /// A call with an effect.
    pub fn mutating_call(&mut self) -> Option<Call> {
        self.call(Function::mutates)
    }

    /// A call of one of the functions that fit and that can still be afforded; most likely of one of the latest.
    fn call(&mut self, fits: impl Fn(&Function) -> bool) -> Option<Call> {
        let mut candidates = Vec::new();
        for (which, function) in self.program.functions.iter().enumerate() {
            let affordable = self.cost + self.costs[which] * self.repeats <= self.limit;
            if fits(function) && affordable {
                candidates.extend(vec![which; 1 + which]);
            }
        }
        if candidates.is_empty() {
            return None;
        }
        let which = *self.choices.pick(&candidates);
        self.call_of(which)
    }

    /// A call of a function; nothing, if there is nothing to lend it.
    pub fn call_of(&mut self, which: usize) -> Option<Call> {
        let lent = self.lent.len();
        let arguments = self.arguments(which);
        self.lent.truncate(lent);
        let call = Call {
            callee: Callee::Function(which),
            arguments: arguments?,
            returns: self.program.functions[which].returns,
        };
        self.spend(self.costs[which]).then_some(call)
    }

    fn arguments(&mut self, which: usize) -> Option<Vec<Argument>> {
        let program = self.program;
        let mut arguments = Vec::new();
        for param in &program.functions[which].params {
            self.choices.enter_named(&param.name);
            let argument = self.argument(param);
            self.choices.leave();
            arguments.push(argument?);
        }
        Some(arguments)
    }

    fn argument(&mut self, param: &Param) -> Option<Argument> {
        Some(match param.mode {
            Mode::Value => {
                let Type::Scalar(scalar) = param.ty else { unreachable!("generate: only scalars go by value") };
                let depth = self.choices.below(3);
                Argument::Value(self.expr(scalar, depth))
            }
            mode => {
                let place = self.borrowable(&param.ty, mode)?;
                self.lent.push((place.clone(), mode));
                if mode == Mode::Shared { Argument::Shared(place) } else { Argument::Mutable(place) }
            }
        })
    }
}
