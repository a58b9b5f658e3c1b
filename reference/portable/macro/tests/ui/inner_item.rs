use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    const STEP: u32 = 1;
    count + STEP
}

fn main() {}
