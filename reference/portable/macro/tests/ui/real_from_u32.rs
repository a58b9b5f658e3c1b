use portable::{Real, portable};

#[portable]
fn ratio<R: Real>(count: u32) -> R {
    R::from_u32(count)
}

fn main() {}
