use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn reset<R: Real>(state: &mut State<R>) {
    let inner = state;
    inner.count = 0u32;
}

fn main() {}
