#![allow(unused)]

use portable::{Real, copy, portable};

#[portable]
struct State<R> {
    s1: R,
    on: bool,
}

#[portable]
struct Other<R> {
    on: R,
}

#[portable]
fn take<R: Real>(state: &mut State<R>, other: &Other<R>) {
    copy!(state = other: s1, on);
}

fn main() {}
