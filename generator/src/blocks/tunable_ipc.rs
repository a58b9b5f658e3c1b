//! The block `ipc` of an axis whose numbers come from parameter sets: what such a set is told by, and the block, which does what `ipc` does.

use super::ipc::notes::note;
use super::values::{Value, Values};
use super::{Certified, Kind, Part, Summary};
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use compiler::program::Program;
use reference::ipc::Ipc;
use reference::tunable_ipc::{Coeffs, TunableIpc};

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
            note(
                "structure",
                format!("parameter sets for the structure {structure} = 16#{structure:08X} are taken over"),
            ),
            note("set_id", format!("the set that the block was generated with has the number {set} = 16#{set:08X}")),
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
        summary.lines.push(format!("takes parameter sets of the structure {structure:08x}; this one is {set:08x}"));
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
    fn certificate(&self, designed: &Designed, _: &Program) -> Certified {
        let program = Kind::program(&Ipc, designed, Some("verified"))
            .expect("tunable_ipc: the block with constants has no defect");
        let mut certified = Ipc.certificate(designed, &program);
        certified.lines.insert(0, "Of the parameter set that the block was generated with:".to_owned());
        certified
    }
}
