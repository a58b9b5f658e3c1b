use portable::portable;

const WEIGHTS: [u32; 3] = [1, 2, 1];

#[portable]
fn next(count: u32) -> u32 {
    count + WEIGHTS[1]
}

fn main() {}
