use portable::portable;

#[portable]
struct State<'a> {
    count: Count<'a>,
}

type Count<'a> = u32;

fn main() {}
