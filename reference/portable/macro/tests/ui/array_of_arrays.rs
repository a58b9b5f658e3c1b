use portable::{Real, portable};

#[portable]
fn first<R: Real>(x: R) -> R {
    let all = [[x; 2]; 3];
    all[0][1]
}

fn main() {}
