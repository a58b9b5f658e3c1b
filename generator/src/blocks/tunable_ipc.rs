//! The block `ipc` of an axis whose numbers come from parameter sets: what such a set is told by, and the block, which does what `ipc` does.

use super::ipc::notes::note;
use super::values::{Value, Values};
use super::{Certified, Figure, Kind, Part, Summary};
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use compiler::pass::Defect;
use compiler::program::Program;
use reference::ipc::Ipc;
use reference::tunable_ipc::{Coeffs, TunableIpc};

/// A number that sets are told by, as names and heads of files have it and as a PLC shows it.
pub(crate) fn shown(number: u32) -> String {
    format!("{number:08x} = {number}")
}

impl Part for TunableIpc {
    fn is_asked_for(&self, axis: &Axis) -> bool {
        axis.ipc.takes_sets
    }

    fn short_name(&self) -> &'static str {
        Ipc.short_name()
    }

    fn design(designed: &Designed) -> Coeffs<f64> {
        let [structure, set_id] = designed.sets;
        Coeffs { structure, set_id, ipc: designed.ipc }
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        let [structure, set] = designed.sets;
        let own = [
            note("structure", format!("parameter sets for the set structure {} are taken over", shown(structure))),
            note("set_id", format!("the set that the block was generated with has the number {}", shown(set))),
        ];
        // Of a stage another set has other numbers.
        let of_ipc = Ipc.notes(designed).into_iter().map(|(path, text)| {
            let text = if path.starts_with("stage") { format!("as generated: {text}") } else { text };
            (format!("ipc.{path}"), text)
        });
        own.into_iter().chain(of_ipc).collect()
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        Ipc.ranges(designed)
    }

    fn start_cycles(&self, designed: &Designed) -> usize {
        Ipc.start_cycles(designed)
    }

    fn summary(&self, designed: &Designed) -> Summary {
        let mut summary = Ipc.summary(designed);
        let [structure, set] = designed.sets;
        let [structure, set] = [structure, set].map(shown);
        summary.lines.push(format!("takes parameter sets of the set structure {structure}; this one is {set}"));
        summary
    }

    fn verdict(&self, designed: &Designed) -> Vec<String> {
        Ipc.verdict(designed)
    }

    /// That it takes sets; what the set says, the block with constants tells.
    fn values(&self, designed: &Designed) -> Values {
        let takes = designed.axis.ipc.takes_sets.then(|| Value::Words("taken over".to_owned()));
        takes.map(|value| ("parameter sets".to_owned(), value)).into_iter().collect()
    }

    /// That of the block with constants, whose program does the same with the set that the block was generated with.
    fn limit(&self, designed: &Designed) -> Option<Figure> {
        Ipc.limit(designed)
    }

    fn certificate(&self, designed: &Designed, _: &Program) -> Result<Certified, Defect> {
        let program = Kind::program(&Ipc, designed, Some("verified"))?;
        let mut certified = Ipc.certificate(designed, &program)?;
        certified.lines.insert(0, "Of the parameter set that the block was generated with:".to_owned());
        for figure in certified.figures.iter_mut().filter(|figure| figure.name == "BOUND") {
            figure.doc.push_str(", with the set that the block was generated with");
        }
        Ok(certified)
    }
}
