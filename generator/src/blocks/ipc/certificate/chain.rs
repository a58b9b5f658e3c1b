//! The stages of a compiled block as chains of second-order sections, found by single steps from unit states. No bound.

use super::super::design::{self, StageDesign};
use super::probe::{Probe, Source};
use compiler::program::{Program, Type};

/// A stage as it acts: `gain * section[n-1](... section[0](x))`.
pub(crate) struct Chain {
    /// the input that it looks at, by its position in the program
    pub input: usize,
    /// the sections, in the order of their execution
    pub section: Vec<Section>,
    /// the weight with its sign; 0 where a limit of 0 mutes the block
    pub gain: f64,
}

/// A section as it acts: `y = s1 + b0 x; s1 = s2 - a1 s1 + from_x[0] x; s2 = from_x[1] x - a2 s1`, on the right the old
/// values. In the form of the coefficients `from_x` is `[b1 - a1 b0, b2 - a2 b0]`.
#[derive(Clone, Copy)]
pub(crate) struct Section {
    pub b0: f64,
    pub a1: f64,
    pub a2: f64,
    /// from the input to s1 and s2
    pub from_x: [f64; 2],
}

/// The chains of stages; `limit` is that of the block: outputs are measured where it does not act.
pub(crate) fn measure(program: &Program, stages: &[&StageDesign], limit: f64) -> Vec<Chain> {
    let mut probe = Probe::new(program, limit);
    let inputs = (0..program.inputs.len()).filter(|input| program.inputs[*input].ty == Type::Real);
    let inputs: Vec<_> = inputs.map(|input| (input, probe.column(&Source::Input(input)))).collect();
    let chain = |stage: &&StageDesign| {
        let places: Vec<_> = stage.section.iter().map(|section| place(program, section)).collect();
        let reads = |(_, column): &&(usize, Vec<f64>)| places.iter().flatten().any(|s| column[*s] != 0.0);
        let (input, column) = inputs.iter().find(reads).expect("certificate: a stage reads an input");
        chain(&mut probe, &places, *input, column)
    };
    stages.iter().map(chain).collect()
}

/// Where the two values that a section remembers are in the state.
pub(crate) fn place(program: &Program, section: &design::Section) -> [usize; 2] {
    let stem = section.element.in_state();
    ["s1", "s2"].map(|name| {
        let path = format!("{stem}.{name}");
        let found = program.state.iter().position(|variable| variable.path == path);
        found.expect("certificate: every designed section has its state")
    })
}

fn chain(probe: &mut Probe<'_>, places: &[[usize; 2]], input: usize, from_input: &[f64]) -> Chain {
    let columns: Vec<_> = places.iter().map(|[s1, _]| probe.column(&Source::State(*s1))).collect();
    let last = places.len() - 1;
    let gain = probe.output(&Source::State(places[last][0]));
    let section = |i: usize| {
        let [s1, s2] = places[i];
        // What reaches a section directly: the input of the stage, or the s1 before it.
        let reaching = if i == 0 { from_input } else { &columns[i - 1] };
        let b0 = if i < last {
            through(reaching, &columns[i], places[i + 1])
        } else if gain == 0.0 {
            0.0
        } else if i > 0 {
            probe.output(&Source::State(places[i - 1][0])) / gain
        } else {
            probe.output(&Source::Alone(input, places[0])) / gain
        };
        Section { b0, a1: -columns[i][s1], a2: -columns[i][s2], from_x: [reaching[s1], reaching[s2]] }
    };
    Chain { input, section: (0..=last).map(section).collect(), gain }
}

/// b0 of a section: what reaches the next one through it, by what would reach it directly.
fn through(reaching: &[f64], direct: &[f64], next: [usize; 2]) -> f64 {
    let by = if direct[next[0]].abs() > direct[next[1]].abs() { next[0] } else { next[1] };
    reaching[by] / direct[by]
}
