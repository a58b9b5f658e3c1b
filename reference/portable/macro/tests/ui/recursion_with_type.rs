use portable::{Real, portable};

#[portable]
fn settle<R: Real>(x: R) -> R {
    if x > R::ONE { settle::<R>(x - R::ONE) } else { x }
}

fn main() {}
