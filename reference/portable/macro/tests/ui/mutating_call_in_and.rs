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
fn done<R: Real>(state: &mut State<R>) -> bool {
    state.count > 3u32
}

#[portable]
fn twice<R: Real>(state: &mut State<R>) -> bool {
    let both = state.count > 0u32 && done(state);
    both
}

fn main() {}
