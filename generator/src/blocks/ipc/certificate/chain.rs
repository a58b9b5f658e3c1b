//! The stages of a compiled block as chains of second-order sections, found by single steps from unit states. No bound.

use super::super::design;
use super::probe::{Probe, Source};
use compiler::program::{Program, Type};

/// A stage as it acts: `gain * section[n-1](... section[0](x))`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// index of the stage
    pub stage: usize,
    /// the input that it looks at, by its position in the program
    pub input: usize,
    /// the sections, in the order of their execution
    pub section: Vec<Section>,
    /// the weight with its sign; 0 where a limit of 0 mutes the block
    pub gain: f64,
}

/// A section as it acts: `y = s1 + b0 x; s1 = s2 - a1 s1 + from_x[0] x; s2 = from_x[1] x - a2 s1`, on the right the old
/// values. In the form of the coefficients `from_x` is `[b1 - a1 b0, b2 - a2 b0]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Section {
    /// from the input to the output of the same cycle
    pub b0: f64,
    /// denominator
    pub a1: f64,
    /// denominator
    pub a2: f64,
    /// from the input to s1 and s2
    pub from_x: [f64; 2],
}

/// The chains of all stages, and the largest relative difference between a step and what they predict for it.
///
/// `stages` are the designed sections of each stage, in the order of their execution; `limit` is that of the block: outputs are
/// measured where it does not act.
pub(super) fn measure(program: &Program, stages: &[&[design::Section]], limit: f64) -> (Vec<Chain>, f64) {
    let mut probe = Probe::new(program, limit);
    let mut error = 0.0_f64;
    let inputs: Vec<usize> = (0..program.inputs.len()).filter(|i| program.inputs[*i].ty == Type::Real).collect();
    let from_input: Vec<Vec<f64>> = inputs.iter().map(|input| probe.column(&Source::Input(*input))).collect();
    let mut chains = Vec::new();
    for (stage, sections) in stages.iter().enumerate().filter(|(_, sections)| !sections.is_empty()) {
        let states: Vec<[usize; 2]> = sections.iter().map(|section| states(program, section)).collect();
        let reads = |column: &Vec<f64>| states.iter().flatten().any(|s| column[*s] != 0.0);
        let read = from_input.iter().position(reads).expect("certificate: a stage reads an input");
        chains.push(chain(&mut probe, stage, &states, inputs[read], &from_input[read], &mut error));
    }
    (chains, error)
}

/// Where the two values that a section remembers are in the state.
fn states(program: &Program, section: &design::Section) -> [usize; 2] {
    let stem = section.element.in_state();
    ["s1", "s2"].map(|name| {
        let path = format!("{stem}.{name}");
        let found = program.state.iter().position(|variable| variable.path == path);
        found.expect("certificate: every designed section has its state")
    })
}

fn chain(
    probe: &mut Probe<'_>,
    stage: usize,
    places: &[[usize; 2]],
    input: usize,
    from_input: &[f64],
    error: &mut f64,
) -> Chain {
    let columns: Vec<Vec<f64>> = places.iter().map(|place| probe.column(&Source::State(place[0]))).collect();
    let outputs: Vec<f64> = places.iter().map(|place| probe.output(&Source::State(place[0]))).collect();
    let last = places.len() - 1;
    let gain = outputs[last];
    // What reaches a section directly: the input of the stage, or the s1 before it.
    let reaching = |i: usize| if i == 0 { from_input } else { columns[i - 1].as_slice() };
    let mut section: Vec<Section> = Vec::with_capacity(places.len());
    for (i, place) in places.iter().enumerate() {
        let [s1, s2] = *place;
        let from_x = [reaching(i)[s1], reaching(i)[s2]];
        let b0 = if gain == 0.0 && i == last {
            0.0
        } else if i < last {
            through(reaching(i), &columns[i], places[i + 1])
        } else if i > 0 {
            outputs[i - 1] / gain
        } else {
            let states = places.iter().flatten().copied().collect();
            probe.output(&Source::Alone { input, states }) / gain
        };
        section.push(Section { b0, a1: -columns[i][s1], a2: -columns[i][s2], from_x });
    }
    let chain = Chain { stage, input, section, gain };
    for (i, place) in places.iter().enumerate() {
        let column = probe.column(&Source::State(place[1]));
        *error = error.max(difference(&column, &[(place[0], 1.0)]));
        *error = error.max(difference(&columns[i], &predicted(&chain, places, Some(i))));
        let output = gain * chain.section[i + 1..].iter().map(|section| section.b0).product::<f64>();
        *error = error.max((outputs[i] - output).abs() / outputs[i].abs().max(f64::MIN_POSITIVE));
    }
    *error = error.max(difference_of(places, from_input, &predicted(&chain, places, None)));
    chain
}

/// b0 of a section: what reaches the next one through it, by what would reach it directly.
fn through(reaching: &[f64], direct: &[f64], next: [usize; 2]) -> f64 {
    let by = if direct[next[0]].abs() > direct[next[1]].abs() { next[0] } else { next[1] };
    reaching[by] / direct[by]
}

/// What the chain says of one step from a unit of s1 of section `from`, or of the input.
fn predicted(chain: &Chain, places: &[[usize; 2]], from: Option<usize>) -> Vec<(usize, f64)> {
    let mut column = Vec::with_capacity(2 * places.len());
    let mut x = 1.0;
    let first = from.map_or(0, |from| {
        let section = &chain.section[from];
        column.extend([(places[from][0], -section.a1), (places[from][1], -section.a2)]);
        from + 1
    });
    for (place, section) in places.iter().zip(&chain.section).skip(first) {
        column.extend([(place[0], section.from_x[0] * x), (place[1], section.from_x[1] * x)]);
        x *= section.b0;
    }
    column
}

/// The largest difference between a column and its entries that are not 0, relative to each.
fn difference(column: &[f64], expected: &[(usize, f64)]) -> f64 {
    let entry = |(index, found): (usize, &f64)| {
        let expected = expected.iter().find(|(at, _)| *at == index).map_or(0.0, |(_, value)| *value);
        let largest = found.abs().max(expected.abs());
        if largest > 0.0 { (found - expected).abs() / largest } else { 0.0 }
    };
    column.iter().enumerate().map(entry).fold(0.0, f64::max)
}

/// The same within one stage: an input may reach others too.
fn difference_of(places: &[[usize; 2]], column: &[f64], expected: &[(usize, f64)]) -> f64 {
    let mut own = vec![0.0; column.len()];
    for s in places.iter().flatten() {
        own[*s] = column[*s];
    }
    difference(&own, expected)
}
