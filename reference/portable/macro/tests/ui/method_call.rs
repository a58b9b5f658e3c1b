use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    count.wrapping_add(1u32)
}

fn main() {}
