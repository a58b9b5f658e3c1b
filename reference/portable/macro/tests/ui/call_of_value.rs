use portable::{Real, portable};

#[portable]
fn half<R: Real>(x: R) -> R {
    x * R::lit(0.5)
}

#[portable]
fn quarter<R: Real>(x: R) -> R {
    (half)(half(x))
}

fn main() {}
