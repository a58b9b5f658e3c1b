use portable::{Real, portable};

#[portable]
fn is_still<R: Real>(x: R) -> bool {
    x == R::ZERO
}

fn main() {}
