use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn read<'a, R: Real>(state: &State<R>) -> R {
    state.x
}

fn main() {}
