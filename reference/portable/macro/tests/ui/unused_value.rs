use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    count + 2u32;
    count + 1u32
}

fn main() {}
