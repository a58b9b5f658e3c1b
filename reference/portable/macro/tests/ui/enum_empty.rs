use portable::portable;

#[portable]
enum Mode {}

fn main() {}
