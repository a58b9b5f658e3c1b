use portable::portable;

#[portable]
struct State<R> {
    x: (R, R),
}

fn main() {}
