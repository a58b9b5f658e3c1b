use portable::portable;

#[portable]
fn next(r#type: u32) -> u32 {
    r#type + 1u32
}

fn main() {}
