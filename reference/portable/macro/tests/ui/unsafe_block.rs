#![allow(unused)]

use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    unsafe { count + 1u32 }
}

fn main() {}
