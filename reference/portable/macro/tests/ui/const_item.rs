use portable::portable;

#[portable]
const STAGES: usize = 3;

fn main() {}
