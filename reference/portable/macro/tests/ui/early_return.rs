use portable::{Real, portable};

#[portable]
fn limit<R: Real>(x: R) -> R {
    if x > R::ONE {
        return R::ONE;
    }
    x
}

fn main() {}
