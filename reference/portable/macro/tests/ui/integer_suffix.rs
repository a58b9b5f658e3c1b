#![allow(unused)]

use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    let step = 1u8;
    count
}

fn main() {}
