use portable::{Real, portable};

#[portable]
fn twice<R: Real>(x: R) -> R {
    let y;
    y = x + x;
    y
}

fn main() {}
