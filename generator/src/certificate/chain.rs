//! The stages of a compiled block as chains of second-order sections, found by single steps from unit states. No bound.

use super::probe::{Probe, Source};
use compiler::program::{Program, Type};

/// A stage as it acts: `gain * section[n-1](... section[0](x))`.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
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
pub struct Section {
    /// from the input to the output of the same cycle
    pub b0: f64,
    /// denominator
    pub a1: f64,
    /// denominator
    pub a2: f64,
    /// from the input to s1 and s2
    pub from_x: [f64; 2],
}

/// Where a section is in the state.
struct Place {
    stage: usize,
    s: [usize; 2],
}

/// The chains of all stages, and the largest relative difference between a step and what they predict for it.
///
/// `limit` is that of the block: outputs are measured where it does not act.
pub fn measure(program: &Program, limit: f64) -> (Vec<Chain>, f64) {
    let places = places(program);
    let mut probe = Probe::new(program, limit);
    let mut error = 0.0_f64;
    let inputs: Vec<usize> = (0..program.inputs.len()).filter(|i| program.inputs[*i].ty == Type::Real).collect();
    let from_input: Vec<Vec<f64>> = inputs.iter().map(|input| probe.column(&Source::Input(*input))).collect();
    let mut chains = Vec::new();
    for places in places.chunk_by(|a, b| a.stage == b.stage) {
        let reads = |column: &Vec<f64>| places.iter().any(|place| place.s.iter().any(|s| column[*s] != 0.0));
        let read = from_input.iter().position(reads).expect("certificate: a stage reads an input");
        let chain = chain(&mut probe, places, inputs[read], &from_input[read], &mut error);
        chains.push(chain);
    }
    (chains, error)
}

/// The sections in the order of the state, which is that of their execution.
fn places(program: &Program) -> Vec<Place> {
    let find = |path: String| program.state.iter().position(|variable| variable.path == path);
    let place = |(s1, path): (usize, &str)| {
        let stem = path.strip_suffix(".s1")?;
        let stage = stem.strip_prefix("stage[")?.split(']').next()?.parse().ok()?;
        Some(Place { stage, s: [s1, find(format!("{stem}.s2"))?] })
    };
    program.state.iter().map(|variable| variable.path.as_str()).enumerate().filter_map(place).collect()
}

fn chain(probe: &mut Probe<'_>, places: &[Place], input: usize, from_input: &[f64], error: &mut f64) -> Chain {
    let columns: Vec<Vec<f64>> = places.iter().map(|place| probe.column(&Source::State(place.s[0]))).collect();
    let outputs: Vec<f64> = places.iter().map(|place| probe.output(&Source::State(place.s[0]))).collect();
    let last = places.len() - 1;
    let gain = outputs[last];
    // What reaches a section directly: the input of the stage, or the s1 before it.
    let reaching = |i: usize| if i == 0 { from_input } else { columns[i - 1].as_slice() };
    let mut section: Vec<Section> = Vec::with_capacity(places.len());
    for (i, place) in places.iter().enumerate() {
        let [s1, s2] = place.s;
        let from_x = [reaching(i)[s1], reaching(i)[s2]];
        let b0 = if gain == 0.0 && i == last {
            0.0
        } else if i < last {
            through(reaching(i), &columns[i], places[i + 1].s)
        } else if i > 0 {
            outputs[i - 1] / gain
        } else {
            let states = places.iter().flat_map(|place| place.s).collect();
            probe.output(&Source::Alone { input, states }) / gain
        };
        section.push(Section { b0, a1: -columns[i][s1], a2: -columns[i][s2], from_x });
    }
    let chain = Chain { stage: places[0].stage, input, section, gain };
    for (i, place) in places.iter().enumerate() {
        let column = probe.column(&Source::State(place.s[1]));
        *error = error.max(difference(&column, &[(place.s[0], 1.0)]));
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
fn predicted(chain: &Chain, places: &[Place], from: Option<usize>) -> Vec<(usize, f64)> {
    let mut column = Vec::with_capacity(2 * places.len());
    let mut x = 1.0;
    let first = from.map_or(0, |from| {
        let section = &chain.section[from];
        column.extend([(places[from].s[0], -section.a1), (places[from].s[1], -section.a2)]);
        from + 1
    });
    for (place, section) in places.iter().zip(&chain.section).skip(first) {
        column.extend([(place.s[0], section.from_x[0] * x), (place.s[1], section.from_x[1] * x)]);
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
fn difference_of(places: &[Place], column: &[f64], expected: &[(usize, f64)]) -> f64 {
    let mut own = vec![0.0; column.len()];
    for s in places.iter().flat_map(|place| place.s) {
        own[s] = column[s];
    }
    difference(&own, expected)
}
