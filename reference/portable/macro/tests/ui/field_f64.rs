use portable::portable;

#[portable]
struct State {
    x: f64,
}

fn main() {}
