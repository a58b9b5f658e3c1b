use portable::portable;

#[portable]
mod section {}

fn main() {}
