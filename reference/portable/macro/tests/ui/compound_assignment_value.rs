#![allow(unused)]

use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    let mut next = count;
    let nothing = next += 1u32;
    next
}

fn main() {}
