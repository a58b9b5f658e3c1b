use portable::portable;

#[portable]
enum Mode {
    Off = 1,
    On,
}

fn main() {}
