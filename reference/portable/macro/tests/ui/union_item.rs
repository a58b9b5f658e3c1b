use portable::portable;

#[portable]
union Bits {
    integer: u32,
}

fn main() {}
