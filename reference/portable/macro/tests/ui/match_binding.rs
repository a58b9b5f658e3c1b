use portable::portable;

#[portable]
fn sign(count: i32) -> i32 {
    match count {
        0i32 => 1i32,
        other => other,
    }
}

fn main() {}
