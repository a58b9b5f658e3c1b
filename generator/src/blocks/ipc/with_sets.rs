//! The block `ipc` of an axis whose numbers come from parameter sets: the texts that differ from those of the block with
//! constants.

use super::notes::note;
use super::sets::{self, shown};
use crate::blocks::{Certified, Design, Designed};
use reference::tunable_ipc::{Coeffs, TunableIpc};

impl Design for TunableIpc {
    fn design(designed: &Designed) -> Coeffs<f64> {
        let [structure, set_id] = designed.sets;
        sets::with(structure, set_id, &designed.ipc)
    }
}

/// Its notes, derived from those of the block with constants.
pub(super) fn notes(designed: &Designed, of_constants: Vec<(String, String)>) -> Vec<(String, String)> {
    let [structure, set] = designed.sets;
    let own = [
        note("structure", format!("accepts parameter sets for the set structure {}", shown(structure))),
        note("set_id", format!("the block was generated with the set number {}", shown(set))),
    ];
    // The numbers of a stage differ from set to set.
    let of_ipc = of_constants.into_iter().map(|(path, text)| {
        let text = if path.starts_with("stage") { format!("as generated: {text}") } else { text };
        (format!("ipc.{path}"), text)
    });
    own.into_iter().chain(of_ipc).collect()
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
