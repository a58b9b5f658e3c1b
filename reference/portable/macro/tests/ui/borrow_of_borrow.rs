use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn read<R: Real>(state: &mut &State<R>) -> R {
    state.x
}

fn main() {}
