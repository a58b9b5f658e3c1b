use portable::portable;

#[portable]
fn half(count: u32) -> u32 {
    count >> 1u32
}

fn main() {}
