use portable::portable;

#[portable]
struct State<R, S> {
    x: R,
    y: S,
}

fn main() {}
