//! The interface of every block: the types around its `step`, and the IR of its two functions. No algorithm.

use crate::{Fn, Portable, Real};

/// An input that turns a block off.
#[derive(Clone, Copy, Debug)]
pub struct Enable {
    /// the input
    pub input: &'static str,
    /// the value that turns the block off
    pub off: Off,
}

/// The kind of an input that turns a block off.
#[derive(Clone, Copy, Debug)]
pub enum Off {
    /// a mode: the function that returns its number for OFF, and the part of the state that is true until the block has
    /// faded out
    Mode(&'static Fn, &'static str),
    /// false, at once
    False,
    /// false: nothing new begins; the part of the state that is true until what began has ended
    Execute(&'static str),
    /// true: the block brakes
    Brake(Brake),
}

/// The signals that show whether a braking block is at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Brake {
    /// the output that is 0 at rest
    pub velocity: &'static str,
    /// the output that has one of the values `resting` at rest
    pub state: &'static str,
    /// the values of `state` at rest
    pub resting: &'static [i32],
    /// the input that is false while the drive is off, and the value of `state` that is rest only then
    pub drive: (&'static str, i32),
}

/// A function block: called once per position-controller cycle.
pub trait Block<R: Real> {
    /// Constants of the block, designed from the parameters.
    type Coeffs: Portable + Send + 'static;
    /// Memory from one cycle to the next.
    type State: Portable;
    /// Inputs, written by the caller in each cycle.
    type Inputs: Portable + Clone;
    /// Outputs, written in each cycle.
    type Outputs: Portable;

    /// The name in files and on the command line.
    const NAME: &'static str;
    /// The real inputs that are fractions from 0 to 1, not samples of a signal.
    const FRACTIONS: &'static [&'static str] = &[];
    /// The struct among the inputs that is a parameter set: it stays until another one is offered.
    const SET: Option<&'static str> = None;
    /// The struct among the outputs that is a parameter set for another block, which checks it.
    const MADE: Option<&'static str> = None;
    /// Whether its real inputs are numbers that somebody types, not samples of a signal: a self-test keeps them.
    const TYPED: bool = false;
    /// `init(state)`: before the first cycle.
    const INIT: Fn;
    /// `step(state, coeffs, inputs, outputs)`: one cycle.
    const STEP: Fn;

    /// Whether `step` begins with the fast path, and its last `else` handles any other cycle. C calls that part as a
    /// separate function, so that the fast path does not save registers.
    fn is_usual_first(_: &Self::Coeffs) -> bool {
        false
    }

    /// The input that turns the block off, if the block has one.
    fn enable(coeffs: &Self::Coeffs) -> Option<Enable>;

    /// Uninitialised memory.
    fn memory() -> Self::State;

    /// Runs `INIT`.
    fn init(state: &mut Self::State);

    /// The state before the first cycle, as `init` sets it in every language.
    fn state() -> Self::State {
        let mut state = Self::memory();
        Self::init(&mut state);
        state
    }

    /// The values that inputs have until the caller writes them.
    fn inputs(coeffs: &Self::Coeffs) -> Self::Inputs;

    /// Sets the switches among the inputs so that the block does everything it can, for a self-test.
    fn exercise(inputs: &mut Self::Inputs, coeffs: &Self::Coeffs);

    /// The values of the outputs before the first cycle.
    fn outputs() -> Self::Outputs;

    /// One cycle.
    fn step(state: &mut Self::State, coeffs: &Self::Coeffs, inputs: &Self::Inputs, outputs: &mut Self::Outputs);
}
