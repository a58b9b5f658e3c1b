use portable::portable;

type Count<'a> = u32;

#[portable]
struct State {
    count: Count<'static>,
}

fn main() {}
