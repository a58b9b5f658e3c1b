#![allow(unused)]

use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    let later = async { 1u32 };
    count
}

fn main() {}
