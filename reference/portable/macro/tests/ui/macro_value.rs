use portable::portable;

#[portable]
fn is_small(count: u32) -> bool {
    matches!(count, 0..3)
}

fn main() {}
