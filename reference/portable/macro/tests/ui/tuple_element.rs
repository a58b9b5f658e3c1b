use portable::{Real, portable};

struct Pair<R>(R);

#[portable]
fn first<R: Real>(x: &Pair<R>) -> R {
    x.0
}

fn main() {}
