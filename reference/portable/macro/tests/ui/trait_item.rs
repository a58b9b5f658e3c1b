use portable::portable;

#[portable]
trait Filter {}

fn main() {}
