#![allow(unused)]

use portable::portable;

#[portable]
fn run(filter: &dyn Send) {}

fn main() {}
