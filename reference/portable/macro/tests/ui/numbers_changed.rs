use portable::{Real, portable, with_numbers};

#[portable]
#[derive(Clone, Copy, Default)]
struct Coeffs<R> {
    order: u32,
    gain: R,
}

#[portable]
fn gain<R: Real>(coeffs: &Coeffs<R>) -> R {
    coeffs.gain
}

#[portable]
fn read<R: Real>(coeffs: &Coeffs<R>) -> R {
    gain(&mut with_numbers(coeffs, coeffs))
}

fn main() {}
