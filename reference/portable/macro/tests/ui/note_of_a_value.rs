use portable::{note, portable};

const WHY: &str = "nobody knows";

#[portable]
fn explain() {
    note(WHY);
}

fn main() {}
