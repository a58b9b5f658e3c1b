//! Random programs of the portable subset: the order in which the parts of one are made.
//!
//! Every program compiles, ends, and stays within its arrays by construction: an index is a number, a loop variable or a
//! coefficient whose bound is known, integers wrap, and a call lends no part twice.

mod block;
mod branch;
mod call;
mod constant;
mod expression;
mod function;
mod idiom;
mod place;
mod scope;
mod shape;
mod statement;

use super::rng::Rng;
use super::syntax::Program;

/// The program that a source of random numbers stands for.
#[must_use]
pub fn program(mut rng: Rng) -> Program {
    let mut program = shape::types(&mut rng);
    function::add_all(&mut program, &mut rng);
    program
}
