//! The model's own tests: each row of the page's tables, the figures that it states, what random histories reach, and that a
//! block with a mistake is found. No formula is here.

mod bench;
mod exceptions;
mod figures;
mod random;
mod requests;
mod states;
