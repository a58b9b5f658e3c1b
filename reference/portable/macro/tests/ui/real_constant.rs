#![allow(unused)]

use portable::{Real, portable};

#[portable]
fn is_double<R: Real>() -> bool {
    let kind = R::KIND;
    true
}

fn main() {}
