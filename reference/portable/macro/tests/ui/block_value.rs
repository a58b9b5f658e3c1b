use portable::portable;

#[portable]
fn next(count: u32) -> u32 {
    let next = {
        let step = 1u32;
        count + step
    };
    next
}

fn main() {}
