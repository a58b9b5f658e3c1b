use portable::portable;

#[portable]
struct State<'a> {
    count: &'a u32,
}

fn main() {}
