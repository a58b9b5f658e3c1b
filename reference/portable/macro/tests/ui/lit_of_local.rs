use portable::{Real, portable};

const HALF: f64 = 0.5;

#[portable]
fn half<R: Real>(x: R) -> R {
    let factor = HALF;
    x * R::lit(factor)
}

fn main() {}
