use portable::portable;

struct Count(u32);

#[portable]
fn next(count: u32) -> u32 {
    take(Count(count))
}

fn take(count: Count) -> u32 {
    count.0
}

fn main() {}
