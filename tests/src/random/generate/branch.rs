//! Random `if` and `match`, as statements and as values.

use super::scope::Writer;
use crate::random::syntax::{Arm, Block, Choice, Expr, Scalar, Selection, Statement, Value};

impl Writer<'_> {
    /// A condition; one in five is known when the program is specialised.
    pub fn condition(&mut self) -> Expr {
        let outside = self.known;
        self.known = outside || (self.knows() && self.choices.chance(25));
        let depth = self.choices.between(1, 2);
        let condition = self.expr(Scalar::Bool, depth);
        self.known = outside;
        condition
    }

    /// Whether there is something that is known.
    fn knows(&self) -> bool {
        self.scope.iter().any(|binding| binding.known)
    }

    /// An `if`; with a value, if its type is given.
    pub fn choice(&mut self, value: Option<Scalar>, depth: usize) -> Choice {
        let condition = self.condition();
        let then = self.branch(value, depth);
        let otherwise = match value {
            // A chain of questions.
            _ if depth > 0 && self.choices.chance(20) => {
                let next = self.choice(value, depth - 1);
                Some(match value {
                    Some(_) => Block { statements: Vec::new(), value: Some(Box::new(Expr::If(Box::new(next)))) },
                    None => Block { statements: vec![Statement::If(next)], value: None },
                })
            }
            None if !self.choices.chance(60) => None,
            _ => Some(self.branch(value, depth)),
        };
        Choice { condition, then, otherwise }
    }

    /// A `match`; with a value, if its type is given.
    pub fn selection(&mut self, value: Option<Scalar>, depth: usize) -> Selection {
        let outside = self.known;
        self.known = outside || (self.knows() && self.choices.chance(20));
        let scrutinee = self.scrutinee();
        self.known = outside;
        let patterns = self.patterns(scrutinee.scalar());
        let arms = patterns.into_iter().map(|patterns| Arm { patterns, body: self.branch(value, depth) }).collect();
        Selection { scrutinee, arms }
    }

    /// The patterns of arms that leave no value out.
    fn patterns(&mut self, scalar: Scalar) -> Vec<Vec<Value>> {
        let mut values: Vec<Value> = match scalar {
            Scalar::Enum(which) => {
                (0..self.program.enums[which]).map(|variant| Value::Variant(which, variant)).collect()
            }
            Scalar::Bool => vec![Value::Bool(false), Value::Bool(true)],
            Scalar::I32 => [0, 1, -1, 2, 3, i32::MIN].map(Value::I32).into(),
            Scalar::U32 => [0, 1, 2, 3, 5].map(Value::U32).into(),
            Scalar::Usize => [0, 1, 2].map(Value::Usize).into(),
            Scalar::Real => unreachable!("generate: a real chooses no arm"),
        };
        let complete = matches!(scalar, Scalar::Enum(_) | Scalar::Bool) && self.choices.chance(50);
        let count = if complete { values.len() } else { self.choices.between(1, values.len().min(3)) };
        let mut arms: Vec<Vec<Value>> = Vec::new();
        for _ in 0..count {
            let value = values.remove(self.choices.below(values.len()));
            match arms.last_mut() {
                Some(last) if self.choices.chance(35) => last.push(value),
                _ => arms.push(vec![value]),
            }
        }
        if !complete {
            arms.push(Vec::new());
        }
        // Rarely, what stands after the wildcard is never reached.
        if self.choices.chance(4) {
            arms.insert(self.choices.below(arms.len()), Vec::new());
        }
        arms
    }

    /// The inside of a branch.
    fn branch(&mut self, value: Option<Scalar>, depth: usize) -> Block {
        let count = match value {
            Some(_) => self.choices.weighted(&[70, 25, 5]),
            None => self.choices.weighted(&[0, 70, 30]),
        };
        self.block(count, value, depth)
    }
}
