//! The block `ipc` of an axis whose numbers come from parameter sets: the texts that differ from those of the block with
//! constants.

use super::sets::{self, shown};
use crate::blocks::{Certified, Design, Designed};
use reference::sets::Coeffs;
use reference::tunable_ipc::TunableIpc;

impl Design for TunableIpc {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        sets::coefficients(designed)
    }
}

/// The notes of a block, from those of its form with constants: these, unless the axis takes sets. The paths lead to the coefficients
/// of the sets, and to those of the form with constants.
pub(in crate::blocks) fn notes(
    designed: &Designed,
    of_constants: Vec<(String, String)>,
    [of_sets, of_block]: [&str; 2],
) -> Vec<(String, String)> {
    if !designed.axis.ipc.takes_sets() {
        return of_constants;
    }
    let [structure, set] = designed.sets;
    let own = [
        ("structure", format!("accepts parameter sets for the set structure {}", shown(structure))),
        ("set_id", format!("the block was generated with the set number {}", shown(set))),
    ];
    let own = own.map(|(name, text)| (format!("{of_sets}{name}"), text));
    // The numbers of a stage differ from set to set.
    let is_of_stage = |path: &str| path.split('.').any(|part| part.starts_with("stage"));
    let of_block = of_constants.into_iter().map(|(path, text)| {
        let text = if is_of_stage(&path) { format!("as generated: {text}") } else { text };
        (format!("{of_block}{path}"), text)
    });
    own.into_iter().chain(of_block).collect()
}

/// The line of its summary.
pub(super) fn line(designed: &Designed) -> String {
    let [structure, set] = designed.sets.map(shown);
    format!("takes parameter sets of the set structure {structure}; this one is {set}")
}

/// The certificate of the block with constants, which applies with the set that the block was generated with.
pub(super) fn as_generated(mut of_constants: Certified) -> Certified {
    of_constants.lines.insert(0, "Of the parameter set that the block was generated with:".to_owned());
    for figure in of_constants.figures.iter_mut().filter(|figure| figure.name == "BOUND") {
        figure.doc.push_str(", with the set that the block was generated with");
    }
    of_constants
}
