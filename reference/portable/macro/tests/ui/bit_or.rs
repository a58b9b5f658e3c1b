use portable::portable;

#[portable]
fn either(a: bool, b: bool) -> bool {
    a | b
}

fn main() {}
