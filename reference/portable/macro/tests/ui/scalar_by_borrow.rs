#![allow(unused)]

use portable::portable;

#[portable]
fn reset(count: &mut u32) {}

fn main() {}
