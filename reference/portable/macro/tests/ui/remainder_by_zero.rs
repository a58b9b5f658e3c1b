use portable::portable;

#[portable]
fn phase(count: u32) -> u32 {
    count % 0u32
}

fn main() {}
