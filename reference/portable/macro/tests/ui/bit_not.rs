use portable::portable;

#[portable]
fn invert(mask: u32) -> u32 {
    !mask
}

fn main() {}
