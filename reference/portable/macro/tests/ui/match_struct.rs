use portable::portable;

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

struct Count {
    count: u32,
}

const COUNT: Count = Count { count: 1 };

#[portable]
fn read() -> u32 {
    match COUNT {
        Count { count: 1 } => 1u32,
        _ => 2u32,
    }
}

fn main() {}
