use portable::portable;

#[portable]
fn add(mask: u32) -> u32 {
    let mut bits = mask;
    bits |= 1u32;
    bits
}

fn main() {}
