use portable::portable;

#[portable]
struct State {
    count: u8,
}

fn main() {}
