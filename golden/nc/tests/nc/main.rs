//! The crate nc: what programs say, and what is refused.
#![forbid(unsafe_code)]

mod garbage;
mod manual;
mod meaning;
mod passed;
mod real;
mod refused;
mod support;
