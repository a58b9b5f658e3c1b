use portable::portable;

#[portable]
struct State {
    x: <f64 as std::ops::Neg>::Output,
}

fn main() {}
