#![allow(unused)]

use portable::portable;

type Maybe = Option<u32>;

const NOTHING: Maybe = None;

#[portable]
fn read() -> Maybe {
    let count = NOTHING?;
    NOTHING
}

fn main() {}
