//! What makes a block of a random program, and of a block something that runs without knowing its types.

use compiler::program::Program;
use compiler::{leaves, specialise};
use portable::{Block, Literal, Portable, Real, RealKind, Ty, Variant};
use std::collections::BTreeMap;

/// A random program as a block.
pub trait Subject<R: Real>: Block<R> {
    /// The coefficients that it is specialised for.
    fn coefficients() -> Self::Coeffs;
}

/// Makes a block of the functions `init` and `step` next to it: its name, its four structs, its coefficients.
#[macro_export]
macro_rules! subject {
    ($name:literal, $state:ty, $coeffs:ty, $inputs:ty, $outputs:ty, $coefficients:expr) => {
        pub struct Subject;

        impl<R: portable::Real> portable::Block<R> for Subject {
            type Coeffs = $coeffs;
            type State = $state;
            type Inputs = $inputs;
            type Outputs = $outputs;

            const NAME: &'static str = $name;
            const INIT: portable::Fn = init::Ir::<R>::IR;
            const STEP: portable::Fn = step::Ir::<R>::IR;

            fn enable(_: &$coeffs) -> Option<portable::Enable> {
                None
            }

            fn memory() -> $state {
                $crate::subject::unset()
            }

            fn init(state: &mut $state) {
                init::<R>(state);
            }

            fn inputs(_: &$coeffs) -> $inputs {
                $crate::subject::unset()
            }

            fn exercise(_: &mut $inputs, _: &$coeffs) {}

            fn outputs() -> $outputs {
                $crate::subject::unset()
            }

            fn step(state: &mut $state, coeffs: &$coeffs, inputs: &$inputs, outputs: &mut $outputs) {
                step::<R>(state, coeffs, inputs, outputs);
            }
        }

        impl<R: portable::Real> $crate::subject::Subject<R> for Subject {
            fn coefficients() -> $coeffs {
                $coefficients
            }
        }
    };
}

/// A random program in one real type, after functions that know no type of its own.
#[derive(Clone, Copy)]
pub struct Instance {
    /// the program's name
    pub name: &'static str,
    /// the real type
    pub real: RealKind,
    /// the type of its state
    pub state: Ty,
    /// the type of its inputs
    pub inputs: Ty,
    /// the type of its outputs
    pub outputs: Ty,
    /// specialises it
    pub specialise: fn() -> Program,
    /// runs the Rust itself, from its start, on one input after the other
    pub run: fn(&[Vec<Literal>]) -> Vec<Frame>,
}

/// What a cycle has changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// all outputs
    pub outputs: Vec<Literal>,
    /// the whole state
    pub state: Vec<Literal>,
}

/// The instance of a program in a real type.
#[must_use]
pub fn instance<R: Real, S: Subject<R>>() -> Instance {
    Instance {
        name: S::NAME,
        real: R::KIND,
        state: <S::State as Portable>::TY,
        inputs: <S::Inputs as Portable>::TY,
        outputs: <S::Outputs as Portable>::TY,
        specialise: || specialise::block::<R, S>(&S::coefficients(), &BTreeMap::new()),
        run: run::<R, S>,
    }
}

fn run<R: Real, S: Subject<R>>(inputs: &[Vec<Literal>]) -> Vec<Frame> {
    let (coefficients, mut state, mut outputs) = (S::coefficients(), S::state(), S::outputs());
    let mut frames = Vec::new();
    for sample in inputs {
        S::step(&mut state, &coefficients, &build(sample), &mut outputs);
        frames.push(Frame { outputs: leaves(&outputs), state: leaves(&state) });
    }
    frames
}

fn build<T: Portable>(leaves: &[Literal]) -> T {
    let mut next = leaves.iter();
    T::build(&mut || *next.next().expect("subject: as many literals as scalars"))
}

/// What memory holds before anything was written to it: the same in every engine.
#[must_use]
pub fn unset<T: Portable>() -> T {
    build(&unset_leaves(T::TY))
}

/// The scalars of [`unset`].
#[must_use]
pub fn unset_leaves(ty: Ty) -> Vec<Literal> {
    let mut leaves = Vec::new();
    scalars(ty, &mut |scalar| {
        let position = u32::try_from(leaves.len()).unwrap_or_default();
        leaves.push(match scalar {
            Ty::Bool => Literal::Bool(position % 2 == 1),
            Ty::I32 => Literal::I32(i32::try_from(position % 4).unwrap_or_default() - 1),
            Ty::U32 => Literal::U32(position % 3),
            Ty::Usize => Literal::Usize(1),
            Ty::Real(RealKind::F64) => Literal::F64(f64::from(position) * 0.25 - 0.5),
            Ty::Real(RealKind::F32) => Literal::F32(<f32 as Real>::from_u32(position) * 0.25 - 0.5),
            Ty::Enum { def: of } => {
                let index = position % u32::try_from(of.variants.len()).unwrap_or(1);
                Literal::Variant(Variant { of, index })
            }
            Ty::Array { .. } | Ty::Struct { .. } => unreachable!("subject: no scalar"),
        });
    });
    leaves
}

/// Calls the function for the type of every scalar, in the order of [`Portable::visit`].
pub fn scalars(ty: Ty, each: &mut dyn FnMut(Ty)) {
    match ty {
        Ty::Array { element, len } => (0..len).for_each(|_| scalars(*element, each)),
        Ty::Struct { def } => def.fields.iter().for_each(|field| scalars(field.ty, each)),
        scalar => each(scalar),
    }
}
