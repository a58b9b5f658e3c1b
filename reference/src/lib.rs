//! The control algorithms, each written once, generic over the real type.
//!
//! Every target language is derived from this source. `step` changes the state and never the coefficients. The numbers of a
//! stage come from [`design`]; unit conversion and parameter ids belong to the generator, not here.
#![expect(clippy::assign_op_pattern, reason = "the portable subset has one way to assign")]
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)] // the emitted comments and the subset's rules come from here

/// Constants as portable functions without parameters: each a doc comment, and `pub fn name() -> Type { value }`.
macro_rules! constants {
    ($($(#[$($doc:tt)*])+ pub fn $name:ident $(<$real:ident: Real>)?() -> $ty:ident $value:tt)+) => {$(
        $(#[$($doc)*])+
        #[portable::portable]
        pub fn $name $(<$real: portable::Real>)?() -> $ty $value
    )+};
}

/// The part of `impl Block<R>` that every block has: the types, `init` and `step` of its own module.
macro_rules! types_init_and_step {
    ($real:ident, $state:ty) => {
        type Coeffs = Coeffs<$real>;
        type State = $state;
        type Inputs = Inputs<$real>;
        type Outputs = Outputs<$real>;

        const INIT: portable::Fn = init::Ir::<$real>::IR;
        const STEP: portable::Fn = step::Ir::<$real>::IR;

        fn memory() -> $state {
            Default::default()
        }

        fn init(state: &mut $state) {
            init(state);
        }

        fn outputs() -> Outputs<$real> {
            Outputs::default()
        }

        fn step(state: &mut $state, coeffs: &Coeffs<$real>, inputs: &Inputs<$real>, outputs: &mut Outputs<$real>) {
            step(state, coeffs, inputs, outputs);
        }
    };
}

pub mod allpass;
pub mod angle;
pub mod axis;
pub mod bandpass;
pub mod call_rate;
pub mod change;
pub mod check_word;
pub mod delay;
pub mod design;
pub mod excitation;
pub mod feedforward;
pub mod filter;
pub mod ipc;
pub mod oscillation;
pub mod position_control;
pub mod precision;
pub mod process_data;
pub mod section;
pub mod set_design;
pub mod sets;
pub mod signal;
pub mod spindle;
pub mod spindle_axis;
pub mod stage;
pub mod sum;
pub mod trapezoidal;
pub mod tunable_axis;
pub mod tunable_ipc;
pub mod tunable_spindle_axis;
pub mod turn;
