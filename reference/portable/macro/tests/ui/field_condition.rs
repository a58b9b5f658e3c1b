use portable::portable;

#[portable]
struct State {
    #[cfg(all())]
    count: u32,
}

fn main() {}
