use portable::portable;

#[portable]
struct State<R, const N: usize> {
    x: [R; N],
}

fn main() {}
