#![allow(unused)]

use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn read<R: Real>(state: &State<R>) -> R {
    let inner = &state.x;
    R::ZERO
}

fn main() {}
