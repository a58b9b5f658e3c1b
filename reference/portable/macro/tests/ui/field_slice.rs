use portable::portable;

#[portable]
struct State<R> {
    count: u32,
    x: [R],
}

fn main() {}
