use portable::portable;

#[portable]
struct State {
    unit: char,
}

fn main() {}
