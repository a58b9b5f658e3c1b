use portable::portable;

#[portable]
enum Source {
    Motor,
    Direct(u32),
}

fn main() {}
