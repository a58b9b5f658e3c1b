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
fn step<R: Real>(state: &mut State<R>) -> u32 {
    state.count += 1u32;
    state.count
}

#[portable]
fn twice<R: Real>(state: &mut State<R>) -> u32 {
    let mut sum = 1u32;
    sum += step(state);
    sum
}

fn main() {}
