//! Changed blocks: evaluated as a compiler is allowed to, or with a planted fault. The caller decides on their use.

use super::block::Block;
use super::op::{Code, Op};
use super::variables::number;
use portable::{Real, RealKind};
use std::collections::HashMap;

impl Block {
    /// The block with every intermediate result of a statement in double precision, if its reals are REAL: a value is
    /// rounded when it is assigned to a variable, an input of an instance or a parameter of a function. A block of LREAL is
    /// unchanged.
    #[must_use]
    pub fn wide(mut self) -> Self {
        if self.variables.real == RealKind::F32 {
            self.ops.iter_mut().for_each(|op| op.wide = true);
        }
        self
    }

    /// The block with fused operations: a product that is an operand of a sum or a difference in the same statement is not
    /// rounded. If both operands of a sum are products, the left one is fused. `which` is one of these places, or all of
    /// them; `None` if such a place does not exist.
    #[must_use]
    pub fn contracted(&self, which: Option<usize>) -> Option<Self> {
        let places = fusible(&self.ops);
        let chosen = match which {
            Some(which) => places.get(which..=which)?,
            None => &places[..],
        };
        let mut block = self.clone();
        for &(product, sum) in chosen {
            block.ops[sum] = fused(self.ops[product], self.ops[sum]);
            skip(&mut block.ops, product);
        }
        (!chosen.is_empty()).then_some(block)
    }

    /// The block without one of its assignments, in the order of the text; `None` if the block has fewer.
    #[must_use]
    pub fn without(&self, which: usize) -> Option<Self> {
        let mut block = self.clone();
        for op in self.assignments.get(which)?.clone() {
            skip(&mut block.ops, op);
        }
        Some(block)
    }

    /// The block with one of the real numbers of its text, in its order, increased by a thousandth. Numbers that are 0, and
    /// start values, do not count. `None` if the block has fewer.
    #[must_use]
    pub fn with_other_constant(&self, which: usize) -> Option<Self> {
        let mut block = self.clone();
        let reals = &mut block.variables.slots.reals;
        let slot = self.variables.numbers.iter().filter(|&&slot| reals[slot as usize] != 0.0).nth(which)?;
        let value = &mut reals[*slot as usize];
        let other = *value + *value * 2f64.powi(-10);
        *value = if self.variables.real == RealKind::F32 { f32::lit(other).to_f64() } else { other };
        Some(block)
    }
}

/// Products that are operands of sums and differences: both operations, in the order of the sums.
fn fusible(ops: &[Op]) -> Vec<(usize, usize)> {
    let mut products = HashMap::new();
    let mut places = Vec::new();
    for (at, op) in ops.iter().enumerate() {
        match op.code {
            // Each part of an expression has a separate slot.
            Code::MultiplyReal if op.part => {
                products.insert(op.to, at);
            }
            Code::AddReal | Code::SubtractReal => {
                let product = products.get(&op.a).or_else(|| products.get(&op.b));
                places.extend(product.map(|&product| (product, at)));
            }
            _ => {}
        }
    }
    places
}

/// A sum or a difference together with the product that is one of its operands.
fn fused(product: Op, sum: Op) -> Op {
    let (code, c) = match (sum.code, sum.a == product.to) {
        (Code::SubtractReal, true) => (Code::FusedSubtract, sum.b),
        (Code::SubtractReal, false) => (Code::FusedSubtractFrom, sum.a),
        (_, true) => (Code::FusedAdd, sum.b),
        (_, false) => (Code::FusedAdd, sum.a),
    };
    Op { code, a: product.a, b: product.b, c, ..sum }
}

/// Replaces an operation by one without effect; the others keep their numbers.
fn skip(ops: &mut [Op], at: usize) {
    ops[at] = Op::new(Code::Jump, number(at + 1), [0, 0]);
}
