use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn reset<R: Real>(x: R) -> R {
    let state = State { x, count: 0u32 };
    state.x
}

fn main() {}
