#![allow(unused)]

use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn next<R: Real>(state: &mut State<R>) -> R {
    state.count += 1u32;
    state.x
}

#[portable]
fn position<R: Real>(state: &mut State<R>) -> usize {
    state.count += 1u32;
    1usize
}

#[portable]
fn count<R: Real>(state: &mut State<R>) -> u32 {
    let mut sum = 0u32;
    for i in 0..position(state) {
        sum += 1u32;
    }
    sum
}

fn main() {}
