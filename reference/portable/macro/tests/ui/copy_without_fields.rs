#![allow(unused)]

use portable::{Real, copy, portable};

#[portable]
struct State<R> {
    s1: R,
}

#[portable]
fn take<R: Real>(state: &mut State<R>, other: &State<R>) {
    copy!(state = other);
}

fn main() {}
