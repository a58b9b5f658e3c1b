use portable::portable;

#[portable]
fn next(zähler: u32) -> u32 {
    zähler + 1u32
}

fn main() {}
