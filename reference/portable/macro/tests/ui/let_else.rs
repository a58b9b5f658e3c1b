#![allow(irrefutable_let_patterns)]

use portable::{Real, portable};

#[portable]
fn twice<R: Real>(x: R) -> R {
    let y = x + x else { unreachable!() };
    y
}

fn main() {}
