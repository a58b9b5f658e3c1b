use portable::portable;

#[portable]
fn next(count: u32, up: bool) -> u32 {
    count + if up { 1u32 } else { 0u32 }
}

fn main() {}
