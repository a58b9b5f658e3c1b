use portable::portable;

#[portable]
struct State<R = bool> {
    x: R,
}

fn main() {}
