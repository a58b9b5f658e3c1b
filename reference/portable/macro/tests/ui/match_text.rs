use portable::portable;

const UNIT: char = 'm';

#[portable]
fn factor() -> u32 {
    match UNIT {
        'm' => 1u32,
        _ => 2u32,
    }
}

fn main() {}
