//! The engine `st`: what a text does, and what is refused.
#![forbid(unsafe_code)]

mod support;

mod case;
mod changed;
mod forms;
mod garbage;
mod instances;
mod no_literal;
mod program;
mod refused;
mod scl;
mod semantics;
