use portable::portable;

#[portable]
fn part(count: u32, parts: u32) -> u32 {
    (count + 1u32) / parts
}

fn main() {}
