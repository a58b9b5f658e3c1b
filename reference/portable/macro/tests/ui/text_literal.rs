#![allow(unused)]

use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    let unit = "mm";
    count
}

fn main() {}
