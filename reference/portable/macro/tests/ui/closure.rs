#![allow(unused)]

use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    let step = || 1u32;
    count
}

fn main() {}
