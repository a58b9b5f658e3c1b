//! Random programs of the portable subset: the order in which the parts of one are made.
//!
//! Every program compiles, ends, and stays within its arrays by construction: an index is a number, a loop variable or a
//! coefficient whose bound is known, integers wrap, and a call lends no part twice. That holds for any choices: a smaller program
//! is made of fewer and smaller ones.

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

use super::choices::Choices;
use super::syntax::Program;

/// The program that choices make.
pub fn program(choices: &mut Choices) -> Program {
    let mut program = shape::types(choices);
    function::add_all(&mut program, choices);
    program
}
