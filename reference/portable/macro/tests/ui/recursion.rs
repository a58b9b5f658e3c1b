use portable::portable;

#[portable]
fn count(n: u32) -> u32 {
    if n > 0u32 { count(n - 1u32) } else { n }
}

fn main() {}
