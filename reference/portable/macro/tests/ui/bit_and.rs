use portable::portable;

#[portable]
fn both(a: bool, b: bool) -> bool {
    a & b
}

fn main() {}
