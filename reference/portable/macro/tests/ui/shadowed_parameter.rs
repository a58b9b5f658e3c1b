use portable::{Real, portable};

#[portable]
fn twice<R: Real>(x: R) -> R {
    let x = x + x;
    x
}

fn main() {}
