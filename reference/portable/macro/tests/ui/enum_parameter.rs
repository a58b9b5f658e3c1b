use portable::portable;

#[portable]
enum Mode<const N: usize> {
    Off,
    On,
}

fn main() {}
