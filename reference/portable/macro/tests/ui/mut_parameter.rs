use portable::{Real, portable};

#[portable]
fn twice<R: Real>(mut x: R) -> R {
    x = x + x;
    x
}

fn main() {}
