use portable::portable;

#[portable]
type Count = u32;

fn main() {}
