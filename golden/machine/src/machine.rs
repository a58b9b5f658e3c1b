//! What a simulated axis is to its controller. No machine is here.

/// What an axis shows. The unit of length is the machine's.
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

/// An axis that obeys velocity commands. It starts at rest at 0.
pub trait Machine {
    /// Cycle of the controller Ts [s].
    fn cycle(&self) -> f64;

    /// Whole cycles, rounded up, that the machine is late in addition to the one for which a command is held.
    fn delay_cycles(&self) -> usize;

    /// What a sensor at the machine shows now, without the way to the controller.
    fn now(&self) -> Measured;

    /// One cycle with a velocity command, which is held. Returns what the controller reads when it computes the next command.
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
