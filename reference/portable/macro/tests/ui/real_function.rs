use portable::{Real, portable};

#[portable]
fn zero<R: Real>() -> R {
    R::default()
}

fn main() {}
