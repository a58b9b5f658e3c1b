use portable::portable;

#[portable]
static STAGES: usize = 3;

fn main() {}
