use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    u32::wrapping_add(count, 1u32)
}

fn main() {}
