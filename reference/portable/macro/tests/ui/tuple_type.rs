#![allow(unused)]

use portable::{Real, portable};

#[portable]
fn run<R: Real>(x: (R, R)) {}

fn main() {}
