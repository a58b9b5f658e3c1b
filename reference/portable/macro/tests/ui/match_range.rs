use portable::portable;

#[portable]
fn sign(count: i32) -> i32 {
    match count {
        0i32..3i32 => 1i32,
        _ => 2i32,
    }
}

fn main() {}
