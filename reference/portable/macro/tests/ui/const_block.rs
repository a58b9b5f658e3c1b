use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    count + const { 1 + 2 }
}

fn main() {}
