use portable::portable;

#[portable]
fn phase(count: i32) -> i32 {
    count % -3i32
}

fn main() {}
