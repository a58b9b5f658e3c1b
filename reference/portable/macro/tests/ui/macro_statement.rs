use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    debug_assert!(count < 3);
    count + 1u32
}

fn main() {}
