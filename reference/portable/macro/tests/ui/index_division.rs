use portable::{Real, portable};

#[portable]
fn sum<R: Real>(x: &[R; 3]) -> R {
    let mut y = R::ZERO;
    for i in 0..3 {
        y = y + x[i / 2];
    }
    y
}

fn main() {}
