//! What the firmware of a drive does with the emitted module of axis X.
#![no_std]
#![forbid(unsafe_code)]

#[path = "../generated/axis_x_ipc.rs"]
pub mod axis_x_ipc;

use axis_x_ipc::{Inputs, Outputs, State};

/// The axis, in a `static` or on the stack: nothing is allocated.
pub struct Axis {
    state: State,
    pub inputs: Inputs,
    outputs: Outputs,
}

impl Axis {
    /// The axis at start-up; `None`: this build computes other bits than the reference, and must not move anything.
    pub fn start() -> Option<Self> {
        if axis_x_ipc::self_test() != 0 {
            return None;
        }
        Some(Self { state: State::new(), inputs: Inputs::new(), outputs: Outputs::new() })
    }

    /// Once per position-controller cycle: the outputs, of which `v_add` is added to the command.
    pub fn cycle(&mut self) -> &Outputs {
        axis_x_ipc::step(&mut self.state, &self.inputs, &mut self.outputs);
        &self.outputs
    }
}
