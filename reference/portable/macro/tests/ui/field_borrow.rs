use portable::portable;

#[portable]
struct State {
    count: &'static u32,
}

fn main() {}
