//! From an axis to its blocks: design, specialise, the passes, the self-test. No target here.

use crate::axis::Axis;
use crate::self_test::{self, SelfTest};
use crate::vector::{self, Vector};
use crate::{certificate, design};
use compiler::pass::{self, Defect};
use compiler::program::Program;
use compiler::specialise;
use portable::Block as Reference;
use portable::{Real, RealKind};
use reference::axis::Axis as WholeAxis;
use reference::feedforward::Feedforward;
use reference::ipc::Ipc;
use reference::position_control::PositionControl;
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
    /// a recorded run
    pub vector: Vector,
    /// what is certain of its range, and its measured response, in words
    pub certificate: Vec<String>,
}

/// A block that an axis may have: a reference with what the axis's parameters make of it.
pub trait Part<R: Real>: Reference<R> {
    /// Whether the parameters of an axis ask for it.
    fn is_asked_for(axis: &Axis) -> bool;

    /// Its coefficients.
    fn coefficients(axis: &Axis) -> Self::Coeffs;

    /// What they mean.
    fn notes(axis: &Axis) -> Vec<(String, String)>;

    /// The ranges of the noise on its real inputs in a self-test: where no limit acts, and where limits do.
    fn ranges(axis: &Axis) -> [f64; 2];
}

/// The blocks in their order. `$each!` is called with each of them.
macro_rules! each_part {
    ($each:ident) => {
        $each!(Ipc);
        $each!(Feedforward);
        $each!(PositionControl);
        $each!(WholeAxis);
    };
}

impl<R: Real> Part<R> for Ipc {
    fn is_asked_for(axis: &Axis) -> bool {
        let control = &axis.control;
        let is_active = axis.ipc.stage.iter().any(Option::is_some);
        // An axis of which nothing is asked gets a block that puts out 0, and a warning.
        is_active || control.feedforward.is_none() && control.position_control.is_none()
    }

    fn coefficients(axis: &Axis) -> Self::Coeffs {
        design::ipc(axis)
    }

    fn notes(axis: &Axis) -> Vec<(String, String)> {
        design::notes(axis)
    }

    fn ranges(axis: &Axis) -> [f64; 2] {
        let (limit, v_max) = (design::ipc::limit(&axis.ipc), axis.ipc.v_max);
        // A narrow band-pass lets little of the noise pass.
        [if limit > 0.0 { limit / 16.0 } else { v_max }, v_max.max(64.0 * limit)]
    }
}

impl<R: Real> Part<R> for Feedforward {
    fn is_asked_for(axis: &Axis) -> bool {
        axis.control.feedforward.is_some()
    }

    fn coefficients(axis: &Axis) -> Self::Coeffs {
        design::feedforward::coefficients(axis)
    }

    fn notes(axis: &Axis) -> Vec<(String, String)> {
        design::control_notes::feedforward(axis)
    }

    fn ranges(axis: &Axis) -> [f64; 2] {
        let coeffs: reference::feedforward::Coeffs<f64> = design::feedforward::coefficients(axis);
        let torque = design::control_notes::largest_torque(&coeffs);
        [torque.min(axis.ipc.v_max) / 16.0, torque.max(axis.ipc.v_max)]
    }
}

impl<R: Real> Part<R> for PositionControl {
    fn is_asked_for(axis: &Axis) -> bool {
        axis.control.position_control.is_some()
    }

    fn coefficients(axis: &Axis) -> Self::Coeffs {
        design::position_control::coefficients(axis)
    }

    fn notes(axis: &Axis) -> Vec<(String, String)> {
        design::control_notes::position_control(axis)
    }

    fn ranges(axis: &Axis) -> [f64; 2] {
        [axis.ipc.v_max / 16.0, axis.ipc.v_max]
    }
}

impl<R: Real> Part<R> for WholeAxis {
    fn is_asked_for(axis: &Axis) -> bool {
        axis.control.position_control.is_some()
    }

    fn coefficients(axis: &Axis) -> Self::Coeffs {
        design::position_control::of_axis(axis)
    }

    fn notes(axis: &Axis) -> Vec<(String, String)> {
        design::control_notes::axis(axis)
    }

    fn ranges(axis: &Axis) -> [f64; 2] {
        let [quiet, loud] = <Ipc as Part<R>>::ranges(axis);
        let [other_quiet, other_loud] = <Feedforward as Part<R>>::ranges(axis);
        [quiet.min(other_quiet), loud.max(other_loud)]
    }
}

/// The names of an axis's blocks, in the order of [`blocks`].
#[must_use]
pub fn names(axis: &Axis) -> Vec<&'static str> {
    let mut names = Vec::new();
    macro_rules! name {
        ($part:ty) => {
            if <$part as Part<f64>>::is_asked_for(axis) {
                names.push(<$part as Reference<f64>>::NAME);
            }
        };
    }
    each_part!(name);
    names
}

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

/// The programs of an axis after the pass of that name; none: as the specialiser gives them.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn programs(axis: &Axis, last: Option<&str>) -> Result<Vec<Program>, Defect> {
    match axis.real {
        RealKind::F64 => programs_as::<f64>(axis, last),
        RealKind::F32 => programs_as::<f32>(axis, last),
    }
}

fn programs_as<R: Real>(axis: &Axis, last: Option<&str>) -> Result<Vec<Program>, Defect> {
    let mut programs = Vec::new();
    macro_rules! program {
        ($part:ty) => {
            if <$part as Part<R>>::is_asked_for(axis) {
                let notes = <$part as Part<R>>::notes(axis).into_iter().collect();
                let specialised = specialise::block::<R, $part>(&<$part as Part<R>>::coefficients(axis), &notes);
                programs.push(match last {
                    Some(last) => pass::run(specialised, Some(last))?,
                    None => specialised,
                });
            }
        };
    }
    each_part!(program);
    Ok(programs)
}

fn blocks_as<R: Real>(axis: &Axis) -> Result<Vec<Block>, Defect> {
    let mut blocks = Vec::new();
    macro_rules! make {
        ($part:ty) => {
            if <$part as Part<R>>::is_asked_for(axis) {
                blocks.push(block::<R, $part>(axis)?);
            }
        };
    }
    each_part!(make);
    for block in &mut blocks {
        // A gantry slave's block never acts: there is nothing to measure.
        if block.program.block == <Ipc as Reference<R>>::NAME && axis.control.master.is_none() {
            block.certificate = certificate::lines(&certificate::certify(axis, block));
        }
    }
    Ok(blocks)
}

/// Runs something with the reference of a block, by its name.
///
/// # Panics
/// If there is no such block.
pub fn with_part<R: Real, V: Visitor<R>>(name: &str, visitor: V) -> V::Value {
    macro_rules! visit {
        ($part:ty) => {
            if name == <$part as Reference<R>>::NAME {
                return visitor.visit::<$part>();
            }
        };
    }
    each_part!(visit);
    panic!("block: no block `{name}`")
}

/// What is done with the reference of a block.
pub trait Visitor<R: Real> {
    /// What comes out.
    type Value;

    /// Does it.
    fn visit<P: Part<R>>(self) -> Self::Value;
}

/// Specialises one block.
fn block<R: Real, P: Part<R>>(axis: &Axis) -> Result<Block, Defect> {
    let (coeffs, ranges) = (P::coefficients(axis), P::ranges(axis));
    let notes = P::notes(axis).into_iter().collect();
    let specialised = specialise::block::<R, P>(&coeffs, &notes);
    let paths: Vec<String> = specialised.state.iter().map(|variable| variable.path.clone()).collect();
    let program = pass::run(specialised, None)?;
    let self_test = self_test::record::<R, P>(&coeffs, &program, &paths, ranges);
    let vector = vector::record::<R, P>(&coeffs, &program, ranges);
    Ok(Block { program, notes, self_test, vector, certificate: Vec::new() })
}
