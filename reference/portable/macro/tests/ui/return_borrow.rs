use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn inner<R: Real>(state: &State<R>) -> &State<R> {
    pass(state)
}

fn pass<R>(state: &State<R>) -> &State<R> {
    state
}

fn main() {}
