use portable::portable;

#[portable]
fn sign(count: u32) -> i32 {
    count as i32
}

fn main() {}
