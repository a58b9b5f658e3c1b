use portable::{Real, portable};

#[portable]
fn twice<R: Real>(x: R) -> R {
    let y = x;
    let y = y + y;
    y
}

fn main() {}
