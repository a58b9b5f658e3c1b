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

/// `take` and `pick` of a section, from its numbers in single and in double precision: in the order of their turns, each with
/// its turn and, if it completes the section, with what it is.
macro_rules! numbers {
    (single: $($s:ident $st:tt $($s_role:ident)?),+; double: $($d:ident $dt:tt $($d_role:ident)?),+; turns: $ss:tt, $ds:tt) => {
        /// Copies the numbers of another section.
        #[portable]
        pub fn take<R: Real>(coeffs: &mut Coeffs<R>, offered: &Coeffs<R>) {
            if is_driven_by_change::<R>() {
                copy!(coeffs = offered: $($s),+);
            } else {
                copy!(coeffs = offered: $($d),+);
            }
        }

        /// Picks the number whose turn it is, its copy, and what it is; turns are numbered from `first`. Returns the turn
        /// after the last one.
        #[portable]
        pub fn pick<R: Real>(picked: &mut Picked<R>, turn: u32, first: u32, numbers: &Coeffs<R>, copy: &Coeffs<R>) -> u32 {
            if is_driven_by_change::<R>() {
                $(if turn == first + $st {
                    picked.number = numbers.$s;
                    picked.copy = copy.$s;
                    $(picked.role = $s_role();)?
                })+
            } else {
                $(if turn == first + $dt {
                    picked.number = numbers.$d;
                    picked.copy = copy.$d;
                    $(picked.role = $d_role();)?
                })+
            }
            if is_driven_by_change::<R>() { first + $ss } else { first + $ds }
        }
    };
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
