//! What a drive does once at start-up: ends with 0 if this build computes the bits of the reference.

extern "C" {
    fn axis_x_ipc_self_test() -> u32;
}

fn main() {
    // The function reads and writes nothing but its own locals.
    let sample = unsafe { axis_x_ipc_self_test() };
    assert!(sample == 0, "other bits than the reference's at sample {sample}");
}
