use portable::portable;

#[portable]
fn half(count: u32, parts: u32) -> u32 {
    let mut half = count;
    half /= parts;
    half
}

fn main() {}
