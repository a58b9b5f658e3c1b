#![allow(unused)]

use portable::{Real, portable};

#[portable]
fn first<R: Real>(x: R) -> R {
    let both = (x, x);
    x
}

fn main() {}
