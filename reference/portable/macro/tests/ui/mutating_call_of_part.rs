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
struct Both<R> {
    first: State<R>,
}

#[portable]
fn twice<R: Real>(both: &mut Both<R>) -> R {
    R::ONE + next(&mut both.first)
}

fn main() {}
