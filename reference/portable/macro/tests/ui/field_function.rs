use portable::portable;

#[portable]
struct State {
    next: fn(u32) -> u32,
}

fn main() {}
