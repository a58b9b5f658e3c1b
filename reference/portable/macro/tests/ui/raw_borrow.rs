#![allow(unused)]

use portable::{Real, portable};

#[portable]
fn read<R: Real>(x: R) -> R {
    let inner = &raw const x;
    R::ZERO
}

fn main() {}
