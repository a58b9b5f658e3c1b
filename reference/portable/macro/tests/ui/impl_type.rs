#![allow(unused)]

use portable::portable;

#[portable]
fn run(filter: &impl Send) {}

fn main() {}
