use portable::{Real, portable};

#[portable]
fn zeros<R: Real>() -> [R; 2] {
    let zeros = [R::ZERO; 2];
    make(&zeros)
}

fn make<R: Real>(x: &[R; 2]) -> [R; 2] {
    *x
}

fn main() {}
