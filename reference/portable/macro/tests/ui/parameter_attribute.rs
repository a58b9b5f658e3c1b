use portable::{Real, portable};

#[portable]
fn twice<R: Real>(#[allow(unused)] x: R) -> R {
    x + x
}

fn main() {}
