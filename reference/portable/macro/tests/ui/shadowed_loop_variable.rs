#![allow(unused)]

use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn count<R: Real>(state: &mut State<R>) {
    for i in 0..2 {
        for i in 0..3 {
            state.count += 1u32;
        }
    }
}

fn main() {}
