//! The crate nc: what programs say, and what is refused.
#![forbid(unsafe_code)]

mod garbage;
mod manual;
mod meaning;
mod refused;
mod support;
