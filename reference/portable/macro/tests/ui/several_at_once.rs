#![allow(unused)]

use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn step<R: Real>(state: &mut State<R>, mut x: R, scale: f64) -> R {
    while state.count < 3u32 {
        state.count += (state.count as u32) ^ 2;
    }
    let x = preset(state) - x.clone();
    return if state.x == R::ZERO { x } else { R::ONE };
}

#[portable]
fn preset<R: Real>(state: &mut State<R>) -> R {
    println!("preset!");
    state.x
}

fn main() {}
