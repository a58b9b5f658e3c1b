use portable::portable;

#[portable]
extern "C" fn next(count: u32) -> u32 {
    count + 1u32
}

fn main() {}
