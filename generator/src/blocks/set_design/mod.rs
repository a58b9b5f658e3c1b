//! The block `set_design`: parameter sets designed on the controller.

pub(crate) mod design;

use super::effects::{Effect, Effects, of_part};
use super::ipc::notes::{cycle_time, note};
use super::ipc::sets::shown;
use super::{BlockKind, Design, Drill, Summary};
use crate::axis::{Axis, Filter};
use crate::blocks::designed::Designed;
use crate::design::rounding::rounded;
use crate::number::digits;
use crate::parameters::words::Words;
use portable::{Block as Reference, Literal, Real, RealKind, Wide};
use reference::set_design::{Coeffs, Inputs, SetDesign};

impl Design for SetDesign {
    /// Frequencies need double precision, for a block in single precision too.
    type Single = Wide;

    fn design(designed: &Designed) -> Coeffs<f64> {
        designed.set_design
    }
}

impl BlockKind for SetDesign {
    fn is_asked_for(&self, axis: &Axis) -> bool {
        axis.ipc.lowest_f0().is_some()
    }

    fn short_name(&self) -> &'static str {
        "sd"
    }

    fn purpose(&self, _: &Designed) -> String {
        "Design of parameter sets for the block ipc of this axis, from numbers that somebody types. A rising edge of execute starts a \
         design, also in the first call; each call does one piece of it, in any task. While the block is not called, an active design \
         waits, and params keeps its values."
            .to_owned()
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        let axis = &designed.axis;
        let Some(lowest) = axis.ipc.lowest_f0() else { return Vec::new() };
        let limit = format!("largest limit of a set: {}", digits(axis.ipc.limit()));
        vec![
            note("lowest_f0", format!("key lowest_f0: {} Hz", digits(lowest))),
            note("v_max", "largest velocity of the axis, P-AXIS-00212".to_owned()),
            note("set.structure", format!("makes parameter sets of the set structure {}", shown(designed.sets[0]))),
            note("set.ipc.cycle_time_ns", cycle_time(axis)),
            note("set.ipc.limit", limit),
        ]
    }

    /// Its inputs are typed: they are no signals, and no noise is put on them.
    fn ranges(&self, _: &Designed) -> [f64; 2] {
        [1.0; 2]
    }

    /// The number of calls of a design.
    fn start_cycles(&self, designed: &Designed) -> usize {
        calls(designed)
    }

    /// The button is pressed again, with half the limit, then with a limit that is refused.
    fn drill(&self, designed: &Designed) -> Vec<Drill> {
        let (limit, calls) = (designed.ipc.limit, calls(designed));
        let part = |input, value, samples| Drill { input, value, samples };
        vec![
            part("limit", Literal::F64(limit / 2.0), 0..2 + calls),
            part("execute", Literal::Bool(false), 0..2),
            part("execute", Literal::Bool(false), 2 + calls..4 + calls),
            part("limit", Literal::F64(-1.0), 4 + calls..8 + calls),
        ]
    }

    fn summary(&self, designed: &Designed) -> Summary {
        let line = format!("set_design: makes parameter sets of the set structure {}", shown(designed.sets[0]));
        Summary { lines: vec![line], ..Summary::default() }
    }

    fn effects(&self, designed: &Designed) -> Effects {
        let ipc = &designed.axis.ipc;
        let number = ipc.lowest_f0().map(|f0| Effect::Number(f0, " Hz"));
        // A set may have another order than the stage, in which the prototype counts.
        let filters = ipc.stage.iter().flatten().flat_map(|stage| &stage.filter);
        let prototypes = filters.filter_map(|filter| match filter {
            Filter::Bandpass { prototype, .. } => Some(prototype.name()),
            Filter::NoFilter | Filter::Allpass { .. } => None,
        });
        let prototypes = number.is_some().then(|| Effect::Words(prototypes.collect::<Vec<_>>().join(", ")));
        of_part("set_design", [("lowest f0", number), ("prototypes", prototypes)])
    }
}

/// The number of calls of a design, which depends on the structure only.
pub fn calls(designed: &Designed) -> usize {
    match designed.axis.real {
        RealKind::F64 => calls_in::<f64>(designed),
        RealKind::F32 => calls_in::<<SetDesign as Design>::Single>(designed),
    }
}

fn calls_in<R: Real>(designed: &Designed) -> usize {
    let coeffs: Coeffs<R> = rounded(&designed.set_design, R::KIND);
    let (mut state, mut outputs) = (<SetDesign as Reference<R>>::state(), <SetDesign as Reference<R>>::outputs());
    let mut inputs: Inputs<R> = SetDesign::inputs(&coeffs);
    inputs.execute = true;
    let mut calls = 0;
    loop {
        SetDesign::step(&mut state, &coeffs, &inputs, &mut outputs);
        calls += 1;
        if !outputs.active {
            return calls;
        }
    }
}
