use portable::portable;

#[portable]
fn half(count: u32) -> u32 {
    let mut half = count;
    half /= 2u32;
    half
}

fn main() {}
