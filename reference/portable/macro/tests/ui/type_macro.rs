use portable::portable;

macro_rules! count {
    () => {
        u32
    };
}

#[portable]
struct State {
    count: count!(),
}

fn main() {}
