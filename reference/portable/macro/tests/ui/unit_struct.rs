use portable::portable;

#[portable]
struct Empty;

fn main() {}
