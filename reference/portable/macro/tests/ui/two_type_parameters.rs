use portable::{Real, portable};

#[portable]
fn first<R: Real, S: Real>(x: R) -> R {
    x
}

fn main() {}
