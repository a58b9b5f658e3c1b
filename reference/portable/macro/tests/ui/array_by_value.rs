use portable::{Real, portable};

#[portable]
fn first<R: Real>(x: [R; 3]) -> R {
    x[0]
}

fn main() {}
