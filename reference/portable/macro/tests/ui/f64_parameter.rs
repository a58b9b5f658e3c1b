#![allow(unused)]

use portable::portable;

#[portable]
fn twice(x: f64) -> u32 {
    1u32
}

fn main() {}
