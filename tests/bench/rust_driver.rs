//! Calls the step of one axis N times with the inputs of driver.c, mode ON; prints a sum, so that nothing can be left out.
//! `block.rs` is the module; the option `--cfg reads_v_command` says that the axis reads it.

#[path = "block.rs"]
mod block;

use block::{Inputs, Outputs, State, step};

/// What is counted: the compiler may put `step` into it, as it may into a user's cycle.
#[inline(never)]
#[no_mangle]
pub extern "C" fn measured_step(state: &mut State, inputs: &Inputs, outputs: &mut Outputs) {
    step(state, inputs, outputs);
}

fn main() {
    let n: u32 = std::env::args().nth(1).map_or(1000, |text| text.parse().expect("a number of cycles"));
    let (mut state, mut inputs, mut outputs) = (State::new(), Inputs::new(), Outputs::new());
    let (mut seed, mut sum) = (1_u32, 0.0);
    // within +-131072 um/s: no limit is reached, both signs occur
    let mut velocity = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from((seed >> 14) as i32 - 131_072)
    };
    inputs.mode = 1;
    for _ in 0..n {
        inputs.v_motor = velocity();
        #[cfg(reads_v_command)]
        {
            inputs.v_command = velocity();
        }
        measured_step(&mut state, &inputs, &mut outputs);
        sum += outputs.v_add;
    }
    println!("{sum:.17e}");
}
