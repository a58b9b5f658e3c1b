use portable::{Real, portable};

#[portable]
fn twice<R: Real>(x: R) -> R
where
    R: Copy,
{
    x + x
}

fn main() {}
