use portable::portable;

#[portable]
struct State<R: Copy> {
    x: R,
}

fn main() {}
