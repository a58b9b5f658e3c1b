use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn reset<R: Real>(state: &mut State<R>) -> () {
    clear(state)
}

#[portable]
fn clear<R: Real>(state: &mut State<R>) {
    state.count = 0u32;
}

fn main() {}
