use portable::portable;

#[portable]
enum Mode {
    Off,
    #[cfg(all())]
    On,
}

fn main() {}
