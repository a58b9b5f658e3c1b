#![allow(unused)]

use portable::{Real, portable};

#[portable]
fn first<R: Real>(x: R) -> R {
    let mut both = [x, x];
    both = [x, R::ZERO];
    both[0]
}

fn main() {}
