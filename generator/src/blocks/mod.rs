//! The function blocks that an axis may have, a folder each, and their registry.
//!
//! ```text
//! designed  an axis with all results of the design
//! block     a block of an axis, ready to be printed
//! kind      the interface of a block's folder
//! products  its products: verified program, self-test, recorded run
//! effects   named effects of two versions, for the semantic diff
//! ```
//! A folder: `check` (rules), `design` (coefficients), `notes` (the meaning of each number), `diff`, and other
//! files that the block needs.

pub(crate) mod axis;
mod block;
mod designed;
mod effects;
pub(crate) mod excitation;
pub(crate) mod feedforward;
pub mod ipc;
mod kind;
pub(crate) mod position_control;
mod products;
pub(crate) mod set_design;
pub(crate) mod spindle;
mod spindle_axis;

pub use crate::exercise::Drill;
pub use block::{Block, Certified, Figure};
pub use designed::Designed;
pub(crate) use effects::{Effect, Effects, differences, differing, is_same};
pub use ipc::feasibility::refusals;
pub use ipc::row::{ActiveStage, Reserve, StageRow, WithDrive};
pub(crate) use ipc::sets::shown;
pub use kind::{BlockKind, Design, Details, Summary, Typed};
pub use set_design::calls as calls_of_design;

use crate::axis::Axis;
use compiler::pass::Defect;
use portable::{Block as Reference, Field};
use reference::{tunable_axis::TunableAxis, tunable_ipc::TunableIpc, tunable_spindle_axis::TunableSpindleAxis};

/// All blocks, in the order in which an axis needs them.
pub(crate) const BLOCKS: [&dyn BlockKind; 8] = [
    &reference::ipc::Ipc,
    &reference::set_design::SetDesign,
    &reference::feedforward::Feedforward,
    &reference::position_control::PositionControl,
    &reference::spindle::Spindle,
    &reference::axis::Axis,
    &reference::spindle_axis::SpindleAxis,
    &reference::excitation::Excitation,
];

/// The blocks whose parameters are known one by one; any other block depends on all parameters of its axis.
pub(crate) const IPC: &str = <reference::ipc::Ipc as Reference<f64>>::NAME;
pub(crate) const FEEDFORWARD: &str = <reference::feedforward::Feedforward as Reference<f64>>::NAME;
pub(crate) const POSITION_CONTROL: &str = <reference::position_control::PositionControl as Reference<f64>>::NAME;
pub(crate) const SPINDLE: &str = <reference::spindle::Spindle as Reference<f64>>::NAME;
pub(crate) const SET_DESIGN: &str = <reference::set_design::SetDesign as Reference<f64>>::NAME;
pub(crate) const EXCITATION: &str = <reference::excitation::Excitation as Reference<f64>>::NAME;

/// The blocks of a whole axis, which contain improved position control.
pub(crate) const WHOLE: [&str; 2] =
    [<reference::axis::Axis as Reference<f64>>::NAME, <reference::spindle_axis::SpindleAxis as Reference<f64>>::NAME];

/// The blocks that the parameters of an axis ask for.
pub fn of_axis(axis: &Axis) -> impl Iterator<Item = &'static dyn BlockKind> {
    BLOCKS.into_iter().filter(|kind| kind.is_asked_for(axis))
}

pub fn names(axis: &Axis) -> Vec<&'static str> {
    of_axis(axis).map(|kind| kind.name()).collect()
}

pub fn named(name: &str) -> Option<&'static dyn BlockKind> {
    BLOCKS.into_iter().find(|kind| kind.name() == name)
}

/// The signals of that name, without or with indices (`tuning_weight0`, `stage0_filter1_f0`): the block, whether it is an output,
/// and its meaning.
pub fn signals(name: &str) -> Vec<(&'static str, bool, &'static str)> {
    let with_sets: [&dyn Typed; 3] = [&TunableIpc, &TunableAxis, &TunableSpindleAxis];
    let references = BLOCKS.iter().map(|kind| *kind as &dyn Typed).chain(with_sets);
    let mut found = Vec::new();
    for reference in references {
        for (fields, is_output) in reference.signals().into_iter().zip([false, true]) {
            let doc = meaning(fields, "", name);
            let is_known = found.iter().any(|(block, of, _)| (*block, *of) == (reference.name(), is_output));
            found.extend(doc.filter(|_| !is_known).map(|doc| (reference.name(), is_output, doc)));
        }
    }
    found
}

/// The meaning of the field that has this name, among those of a struct and of the structs within it.
fn meaning(fields: &'static [Field], before: &str, wanted: &str) -> Option<&'static str> {
    fields.iter().find_map(|field| {
        let name = format!("{before}{}", field.name);
        let is_wanted = is_named(wanted, &name);
        is_wanted.then_some(field.doc).or_else(|| meaning(products::fields(&field.ty), &format!("{name}_"), wanted))
    })
}

/// Whether a written name is that of a field, with or without the indices of the arrays above it: `tuning_weight0`.
fn is_named(written: &str, name: &str) -> bool {
    let [written, name] = [written, name].map(|name| name.split(['_', '.']));
    let is_digit = |letter: char| letter.is_ascii_digit();
    // A digit in the name itself is not an index: m3 and m4 are different signals.
    let is_part = |(written, name): (&str, &str)| {
        written.eq_ignore_ascii_case(name)
            || !name.ends_with(is_digit) && written.trim_end_matches(is_digit).eq_ignore_ascii_case(name)
    };
    written.clone().count() == name.clone().count() && written.zip(name).all(is_part)
}

/// The blocks of an axis, ready to be printed.
///
/// # Errors
/// A defect of a block or of a pass.
pub fn blocks(designed: &Designed) -> Result<Vec<Block>, Defect> {
    of_axis(&designed.axis).map(|kind| kind.block(designed)).collect()
}
