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
fn twice<R: Real>(state: &mut State<R>) -> R {
    let twice = [next(state); 2];
    twice[0]
}

fn main() {}
