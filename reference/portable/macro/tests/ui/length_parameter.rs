use portable::{Real, portable};

#[portable]
fn first<R: Real, const N: usize>(x: R) -> R {
    x
}

fn main() {}
