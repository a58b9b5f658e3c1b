#![allow(unreachable_patterns)]

use portable::portable;

#[portable]
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Off,
    On,
}

#[portable]
fn factor(mode: Mode) -> u32 {
    match mode {
        Mode::On => 1u32,
        Mode::Off | _ => 2u32,
    }
}

fn main() {}
