use portable::portable;

const LIMIT: Option<u32> = Some(3);

#[portable]
fn limit(count: u32) -> u32 {
    if let Some(limit) = LIMIT { limit } else { count }
}

fn main() {}
