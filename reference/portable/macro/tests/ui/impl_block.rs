use portable::portable;

struct Counter;

#[portable]
impl Counter {}

fn main() {}
