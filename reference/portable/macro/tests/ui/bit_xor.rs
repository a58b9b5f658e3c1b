use portable::portable;

#[portable]
fn one(a: bool, b: bool) -> bool {
    a ^ b
}

fn main() {}
