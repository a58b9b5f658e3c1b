use portable::portable;

#[portable]
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Off,
    On,
}

#[portable]
fn next(count: u32, mode: Mode) -> u32 {
    count
        + match mode {
            Mode::On => 1u32,
            Mode::Off => 0u32,
        }
}

fn main() {}
