use portable::{Real, portable};

#[portable]
fn preset<R: Real>(x: R) -> R {
    if x > R::ONE { preset::<R>(x - R::ONE) } else { x }
}

fn main() {}
