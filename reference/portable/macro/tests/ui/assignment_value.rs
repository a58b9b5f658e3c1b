#![allow(unused)]

use portable::{Real, portable};

#[portable]
fn twice<R: Real>(x: R) -> R {
    let mut y = x;
    let nothing = (y = x + x);
    y
}

fn main() {}
