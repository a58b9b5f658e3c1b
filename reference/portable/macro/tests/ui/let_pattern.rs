use portable::portable;

struct Count {
    of: u32,
}

const COUNT: Count = Count { of: 3 };

#[portable]
fn next() -> u32 {
    let Count { of } = COUNT;
    of + 1u32
}

fn main() {}
