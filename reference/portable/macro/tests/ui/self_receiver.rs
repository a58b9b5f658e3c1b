use portable::portable;

struct Counter {
    count: u32,
}

impl Counter {
    #[portable]
    fn next(&mut self) {
        self.count += 1u32;
    }
}

fn main() {}
