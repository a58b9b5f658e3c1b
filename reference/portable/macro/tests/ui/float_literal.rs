use portable::portable;

const HALF: f64 = 0.5;

#[portable]
fn is_less() -> bool {
    HALF < 0.25
}

fn main() {}
