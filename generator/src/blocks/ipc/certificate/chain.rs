//! The stages of a compiled block as chains of second-order sections, measured by single steps from unit states. No bound.

use super::super::stage::{self, StageDesign};
use super::probe::{Probe, Source};
use super::section::{Biquad, Section};
use super::widened::widened;
use crate::design::trapezoidal::Trapezoidal;
use compiler::program::{Program, Type};
use portable::RealKind;

/// A stage as measured: `gain * section[n-1](... section[0](x))`.
pub struct Chain {
    /// its input, as a position in the program
    pub input: usize,
    /// the sections, in the order of their execution
    pub section: Vec<Section>,
    /// the weight with its sign; 0 if a limit of 0 mutes the block
    pub gain: f64,
}

/// The chains of stages. `limit` is that of the block: outputs are measured where it does not act. A program of single
/// precision is measured in double precision, which shows the effect of its rounded coefficients.
pub fn measure(program: &Program, stages: &[&StageDesign], limit: f64) -> Vec<Chain> {
    let wide = widened(program);
    let mut probe = Probe::new(&wide, program.real, limit);
    let inputs = (0..program.inputs.len()).filter(|input| program.inputs[*input].ty == Type::Real);
    let inputs: Vec<_> = inputs.map(|input| (input, probe.column(&Source::Input(input)))).collect();
    let chain = |stage: &&StageDesign| {
        let places: Vec<_> = stage.section.iter().map(|section| place(program, section)).collect();
        let reads = |(_, column): &&(usize, Vec<f64>)| places.iter().any(|place| column[place.s[0]] != 0.0);
        let (input, column) = inputs.iter().find(reads).expect("certificate: a stage reads an input");
        if program.real == RealKind::F64 {
            biquads(&mut probe, &places, *input, column)
        } else {
            trapezoidal(&mut probe, &places, stage, *input)
        }
    };
    stages.iter().map(chain).collect()
}

/// The place of a section in the state.
pub struct Place {
    /// the two values of its state
    pub s: [usize; 2],
    /// whether the second one is driven by the change of the input
    pub is_by_change: bool,
}

/// The place of a section in the state: s1 and s2 of a biquad, s1 and p or low of a trapezoidal section.
pub fn place(program: &Program, section: &stage::Section) -> Place {
    let stem = section.element.in_state();
    let at = |name| {
        let path = format!("{stem}.{name}");
        program.state.iter().position(|variable| variable.path == path)
    };
    let (s1, p) = (at("s1"), at("p"));
    let second = p.or_else(|| at("s2")).or_else(|| at("low"));
    let s = [s1, second].map(|found| found.expect("certificate: every designed section has its state"));
    Place { s, is_by_change: p.is_some() }
}

fn biquads(probe: &mut Probe<'_>, places: &[Place], input: usize, from_input: &[f64]) -> Chain {
    let columns: Vec<_> = places.iter().map(|place| probe.column(&Source::State(place.s[0]))).collect();
    let last = places.len() - 1;
    let gain = probe.output(&Source::State(places[last].s[0]));
    let section = |i: usize| {
        let [s1, s2] = places[i].s;
        // The direct input of a section: the input of the stage, or the s1 before it.
        let reaching = if i == 0 { from_input } else { &columns[i - 1] };
        let b0 = if i < last {
            through(reaching, &columns[i], places[i + 1].s)
        } else if gain == 0.0 {
            0.0
        } else if i > 0 {
            probe.output(&Source::State(places[i - 1].s[0])) / gain
        } else {
            probe.output(&Source::Alone(input, places[0].s)) / gain
        };
        let from_x = [reaching[s1], reaching[s2]];
        Section::Biquad(Biquad { b0, a1: -columns[i][s1], a2: -columns[i][s2], from_x })
    };
    Chain { input, section: (0..=last).map(section).collect(), gain }
}

/// b0 of a section: the response of the next section through it, divided by the response to a direct input.
fn through(reaching: &[f64], direct: &[f64], next: [usize; 2]) -> f64 {
    let by = if direct[next[0]].abs() > direct[next[1]].abs() { next[0] } else { next[1] };
    reaching[by] / direct[by]
}

/// A step from s1 = 1 leads to s1 = 1 - B and p = -C (2 - B), one from p = 1 to s1 = A. With low instead of p, both have the
/// opposite sign.
fn trapezoidal(probe: &mut Probe<'_>, places: &[Place], stage: &StageDesign, input: usize) -> Chain {
    let mut section = |(place, section): (&Place, &stage::Section)| {
        let [s1, second] = place.s;
        let [from_s1, from_second] = place.s.map(|s| probe.column(&Source::State(s)));
        let sign = if place.is_by_change { 1.0 } else { -1.0 };
        let (a, b) = (sign * from_second[s1], 1.0 - from_s1[s1]);
        let c = -sign * from_s1[second] / (2.0 - b);
        Trapezoidal { a, b, c, output: section.trapezoidal.output, is_by_change: place.is_by_change }
    };
    let section: Vec<_> = places.iter().zip(&stage.section).map(&mut section).collect();
    let (last, place) = (section.last(), places.last());
    let (last, place) = last.zip(place).expect("certificate: a stage has a section");
    let output = probe.output(&Source::State(place.s[0]));
    let gain = output / (2.0 - last.b) / last.output.of_bandpass();
    Chain { input, section: section.into_iter().map(Section::Trapezoidal).collect(), gain }
}
