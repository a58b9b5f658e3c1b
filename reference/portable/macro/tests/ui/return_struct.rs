use portable::{Real, portable};

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn zero<R: Real>() -> State<R> {
    make()
}

fn make<R: Real>() -> State<R> {
    State { x: R::ZERO, count: 0 }
}

fn main() {}
