use portable::{Real, portable};

#[portable]
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Off,
    On,
}

#[portable]
struct State<R> {
    x: R,
    count: u32,
}

#[portable]
fn count<R: Real>(state: &mut State<R>, mode: Mode) {
    match mode {
        Mode::On => state.count += 1u32,
        Mode::Off => (),
    }
}

fn main() {}
