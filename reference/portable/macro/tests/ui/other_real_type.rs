use portable::{Real, portable};

#[portable]
fn half<R: Real>(x: R) -> R {
    x * R::lit(0.5)
}

#[portable]
fn check() -> bool {
    half::<f64>(LIMIT) > LIMIT
}

const LIMIT: f64 = 1.0;

fn main() {}
