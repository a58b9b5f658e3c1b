use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    #[allow(unused)]
    let next = count + 1u32;
    next
}

fn main() {}
