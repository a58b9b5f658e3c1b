#![allow(unused)]

use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    let all = 0..3;
    count
}

fn main() {}
