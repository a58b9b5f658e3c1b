use portable::portable;

type Delay<const N: usize> = [u32; N];

#[portable]
struct State {
    count: Delay<3>,
}

fn main() {}
