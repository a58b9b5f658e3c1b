use portable::portable;

#[portable]
struct Pair<R>(R, R);

fn main() {}
