use portable::portable;

const LIMIT: Option<u32> = Some(3);

#[portable]
fn limit(count: u32) -> u32 {
    if count > 0u32 && let Some(limit) = LIMIT { limit } else { count }
}

fn main() {}
