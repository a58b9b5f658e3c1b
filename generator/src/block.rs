//! From an axis to its blocks: design, specialise, the passes, and the answers that a self-test expects. No target here.

use crate::axis::Axis;
use crate::pass::{self, Defect};
use crate::program::{Program, Type};
use crate::{design, specialise};
use portable::{Literal, Portable, Real, RealKind};
use reference::{Block as Reference, ipc::Ipc};
use std::collections::BTreeMap;

/// A block of one axis, ready to be printed.
#[derive(Clone, Debug)]
pub struct Block {
    /// the verified program
    pub program: Program,
    /// what the coefficients under a path mean, for a reviewer
    pub notes: BTreeMap<String, String>,
    /// what a self-test does and expects
    pub self_test: SelfTest,
}

/// A short run whose answers the reference has given.
#[derive(Clone, Debug, PartialEq)]
pub struct SelfTest {
    /// inputs that differ from their start, by position
    pub switches: Vec<(usize, Literal)>,
    /// the factor of the noise on the real inputs, a power of two
    pub scale: Literal,
    /// the samples in which a real input is no number, with the position of the input
    pub bad: Vec<(usize, usize)>,
    /// the first real output of each sample
    pub expected: Vec<Literal>,
    /// the real parts of the state after the last sample, by position in [`Program::state`]
    pub state: Vec<(usize, Literal)>,
}

/// Samples of a self-test behind the bad ones: enough that a fused multiplication shows in the last bits.
const SELF_TEST_SAMPLES: usize = 32;
/// From a bad sample to the next: a block that has noticed it starts anew in the second sample and acts in the third.
const BAD_SAMPLE_DISTANCE: usize = 3;

/// The blocks of an axis.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn blocks(axis: &Axis) -> Result<Vec<Block>, Defect> {
    match axis.real {
        RealKind::F64 => blocks_as::<f64>(axis),
        RealKind::F32 => blocks_as::<f32>(axis),
    }
}

fn blocks_as<R: Real>(axis: &Axis) -> Result<Vec<Block>, Defect> {
    let notes = design::notes(axis).into_iter().collect();
    Ok(vec![block::<R, Ipc>(&design::ipc::<R>(axis), notes, axis.ipc.v_max)?])
}

/// Specialises one block. `range` is the largest value that its real inputs take in operation.
fn block<R: Real, B: Reference<R>>(
    coeffs: &B::Coeffs,
    notes: BTreeMap<String, String>,
    range: f64,
) -> Result<Block, Defect> {
    let specialised = specialise::block::<R, B>(coeffs, &notes);
    let paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let program = pass::run(specialised, None)?;
    let self_test = self_test::<R, B>(coeffs, &program, &paths, range);
    Ok(Block { program, notes, self_test })
}

/// Runs the reference on noise from the generator that every target has too. At the beginning each real input is no
/// number for a sample: a build that takes it for one goes on with other bits.
fn self_test<R: Real, B: Reference<R>>(
    coeffs: &B::Coeffs,
    program: &Program,
    state_paths: &[String],
    range: f64,
) -> SelfTest {
    // A power of two, so that the noise is exact in both real types: noise = scale * (integer of 24 bits - 2^23).
    let scale = R::lit(libm::exp2(libm::floor(libm::log2(range.max(1.0))) - 23.0));
    let mut inputs = B::inputs(coeffs);
    B::exercise(&mut inputs);
    let switched = leaves(&inputs);
    let switches = (0..program.inputs.len())
        .filter(|index| switched[*index] != program.inputs[*index].start)
        .map(|index| (index, switched[index]))
        .collect();
    let reals = (0..program.inputs.len()).filter(|index| program.inputs[*index].ty == Type::Real);
    let bad: Vec<(usize, usize)> = (1..).step_by(BAD_SAMPLE_DISTANCE).zip(reals).collect();
    let (mut state, mut outputs) = (B::state(), B::outputs());
    let (mut random, mut expected) = (1u32, Vec::new());
    for sample in 0..BAD_SAMPLE_DISTANCE * bad.len() + SELF_TEST_SAMPLES {
        let mut values = switched.iter().enumerate().map(|(index, value)| match program.inputs[index].ty {
            Type::Real => {
                random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let noise = (R::from_u32(random >> 8) - R::lit(8_388_608.0)) * scale;
                leaves(&if bad.contains(&(sample, index)) { R::lit(f64::NAN) } else { noise })[0]
            }
            _ => *value,
        });
        let inputs = B::Inputs::build(&mut || values.next().expect("block: as many values as inputs"));
        B::step(&mut state, coeffs, &inputs, &mut outputs);
        expected.push(leaves(&outputs)[0]);
    }
    let last = leaves(&state);
    let state = program.state.iter().enumerate().filter(|(_, variable)| variable.ty == Type::Real);
    let state = state.filter_map(|(index, variable)| {
        let leaf = state_paths.iter().position(|path| *path == variable.path)?;
        Some((index, last[leaf]))
    });
    SelfTest { switches, scale: leaves(&scale)[0], bad, expected, state: state.collect() }
}

/// The scalars of a value, in the order of its type.
pub fn leaves<T: Portable>(value: &T) -> Vec<Literal> {
    let mut leaves = Vec::new();
    value.visit(&mut |literal| leaves.push(literal));
    leaves
}
