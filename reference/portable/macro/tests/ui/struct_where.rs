use portable::{Real, portable};

#[portable]
struct State<R>
where
    R: Real,
{
    x: R,
}

fn main() {}
