use portable::portable;

#[portable(inline)]
fn next(count: u32) -> u32 {
    count + 1u32
}

fn main() {}
