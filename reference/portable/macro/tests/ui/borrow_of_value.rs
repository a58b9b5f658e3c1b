use portable::{Real, portable};

#[portable]
fn half<R: Real>(x: R) -> R {
    x * R::lit(0.5)
}

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn read<R: Real>(state: &State<R>) -> R {
    look(&half(state.x))
}

fn look<R: Real>(x: &R) -> R {
    *x
}

fn main() {}
