use portable::portable;

#[portable]
fn twice<R: Copy>(x: R) -> R {
    x
}

fn main() {}
