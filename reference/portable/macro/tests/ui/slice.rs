use portable::{Real, portable};

#[portable]
fn first<R: Real>(x: &[R]) -> R {
    x[0]
}

fn main() {}
