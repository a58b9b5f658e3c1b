#![allow(unused)]

use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

const LOW: u32 = 0;

#[portable]
fn count<R: Real>(state: &mut State<R>) {
    for i in LOW..3u32 {
        state.count += 1u32;
    }
}

fn main() {}
