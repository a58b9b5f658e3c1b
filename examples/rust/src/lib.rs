//! What the firmware of a drive does with the emitted blocks of its axes.
#![no_std]
#![forbid(unsafe_code)]

pub use axes::{axis_x_ipc, Block};

/// A block of an axis, in a `static` or on the stack: nothing is allocated.
pub struct Axis<B: Block> {
    state: B,
    pub inputs: B::Inputs,
    outputs: B::Outputs,
}

impl<B: Block> Axis<B> {
    /// The block at start-up, called every `cycle_ns`. `None`: it was designed for another cycle time, or this build
    /// computes other bits than the reference, and must not move anything.
    pub fn start(cycle_ns: u32) -> Option<Self> {
        let is_right = B::CYCLE_TIME_NS == cycle_ns && B::self_test() == 0;
        is_right.then(|| Self { state: B::default(), inputs: B::Inputs::default(), outputs: B::Outputs::default() })
    }

    /// Once per position-controller cycle: the outputs, of which `v_add` is added to the command.
    pub fn cycle(&mut self) -> &B::Outputs {
        self.state.step(&self.inputs, &mut self.outputs);
        &self.outputs
    }

    /// The error id of the last cycle; 0 for none.
    pub fn error_id(&self) -> u32 {
        B::error_id(&self.outputs)
    }
}
