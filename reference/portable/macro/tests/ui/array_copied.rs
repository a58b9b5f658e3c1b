#![allow(unused)]

use portable::{Real, portable};

#[portable]
fn first<R: Real>(x: R) -> R {
    let both = [x, x];
    let again = both;
    x
}

fn main() {}
