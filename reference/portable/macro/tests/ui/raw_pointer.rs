#![allow(unused)]

use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn read<R: Real>(state: *const State<R>) -> u32 {
    1u32
}

fn main() {}
