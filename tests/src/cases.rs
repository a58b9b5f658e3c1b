//! The golden cases, and each of them in the other real type as well, where its filters bear it.

use crate::model::subject::read;
use generator::axis::Axis;
use generator::blocks::{Designed, refusals};
use golden::case::{self, Case};
use portable::RealKind;
use std::path::{Path, PathBuf};

/// All golden cases, in the order of their names.
///
/// # Panics
/// If one cannot be read.
#[must_use]
pub fn all() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases");
    let folders = case::folders(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let read = |folder: &PathBuf| case::read(folder).unwrap_or_else(|error| panic!("{error}"));
    folders.iter().map(read).collect()
}

/// All golden cases, each followed by its twin in the other real type, unless rounding would spoil a filter there.
///
/// # Panics
/// If one cannot be read or made.
#[must_use]
pub fn in_both_real_types() -> Vec<Case> {
    all().into_iter().flat_map(|case| [Some(case.clone()), twin(&case)]).flatten().collect()
}

/// Axes of which little is asked: no input gets noise; or one does, which is a part from 0 to 1.
#[must_use]
pub fn without_stages() -> [Designed; 2] {
    let set = |more| format!("cycle_time = '1ms'\n[axis.X]\n{more}getriebe = [{{ dynamik.vb_max = 530000 }}]\n");
    ["", "tunable = 'weights'\n"].map(|more| read(&set(more)))
}

/// The folder's name, with the real type.
#[must_use]
pub fn title(case: &Case) -> String {
    let name = case.folder.file_name().unwrap_or_default().to_string_lossy();
    let real = match case.axis.axis.real {
        RealKind::F64 => "f64",
        RealKind::F32 => "f32",
    };
    format!("{name}, {real}")
}

/// The case in the other real type.
fn twin(case: &Case) -> Option<Case> {
    let real = match case.axis.axis.real {
        RealKind::F64 => RealKind::F32,
        RealKind::F32 => RealKind::F64,
    };
    let axis = Designed::from(Axis { real, ..case.axis.axis.clone() });
    if !refusals(&axis).is_empty() {
        return None;
    }
    let block = case::named_block(&axis, case.block.program.block);
    let block = block.unwrap_or_else(|error| panic!("{}: {error}", title(case)));
    Some(Case { axis, block, ..case.clone() })
}
