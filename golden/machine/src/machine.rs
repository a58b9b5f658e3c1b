//! The interface of a simulated axis for its controller. No machine is here.

/// The measured values of an axis. The unit of length is the machine's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// position of the motor
    pub x: f64,
    /// velocity of the motor
    pub v_motor: f64,
    /// velocity of the load
    pub v_load: f64,
    /// acceleration of the load
    pub a_load: f64,
}

/// An axis that follows velocity commands. It starts at rest at 0.
pub trait Machine {
    /// Cycle of the controller Ts [s].
    fn cycle(&self) -> f64;

    /// Delay of the machine in whole cycles, rounded up, in addition to the cycle in which a command is held.
    fn delay_cycles(&self) -> usize;

    /// The present values at the machine, without the delay to the controller.
    fn now(&self) -> Measured;

    /// One cycle with a velocity command, which is held. Returns the values that the controller reads for the next command.
    fn step(&mut self, v_cmd: f64) -> Measured;
}

impl<M: Machine + ?Sized> Machine for Box<M> {
    fn cycle(&self) -> f64 {
        (**self).cycle()
    }

    fn delay_cycles(&self) -> usize {
        (**self).delay_cycles()
    }

    fn now(&self) -> Measured {
        (**self).now()
    }

    fn step(&mut self, v_cmd: f64) -> Measured {
        (**self).step(v_cmd)
    }
}
