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
fn pick<R: Real>(state: &mut State<R>, x: &[R; 3]) -> R {
    x[position(state)]
}

fn main() {}
