//! Single steps of a block against what its measured sections predict for them: nothing of the block is missing in a chain.

use super::{block, rack_and_pinion};
use crate::inside::sets;
use compiler::program::Program;
use generator::axis::Axis;
use generator::blocks::Designed;
use generator::blocks::ipc::certificate::chain::{Chain, Place, measure, place};
use generator::blocks::ipc::certificate::probe::{Probe, Source};
use portable::{Extreme, RealKind};

/// The largest amplitude of a probe in single precision.
const LARGEST: f64 = 536_870_912.0;

#[test]
fn a_step_is_what_the_sections_predict() {
    let error = error(&rack_and_pinion(RealKind::F64));
    assert!(error < 1e-15, "{error:e}");
    for (real, allowed) in [(RealKind::F64, 1e-12), (RealKind::F32, 1e-4)] {
        for axis in sets::axes(150, real).filter(|axis| axis.ipc.v_add_max_fact > 0) {
            let error = self::error(&axis);
            assert!(error < allowed, "{error:e}: {axis:?}");
        }
    }
}

/// The largest relative difference between a single step of the block and what its sections predict for it.
fn error(axis: &Axis) -> f64 {
    let (designed, program, limit) = (Designed::from(axis.clone()), block(axis).program, axis.ipc.limit());
    let mut probe = Probe::new(&program, program.real, limit);
    let stages: Vec<_> = designed.stage.iter().flatten().collect();
    let mut error = 0.0_f64;
    for (chain, stage) in measure(&program, &stages, limit).iter().zip(stages) {
        let places: Vec<Place> = stage.section.iter().map(|section| place(&program, section)).collect();
        for (i, place) in places.iter().enumerate() {
            for (which, state) in place.s.into_iter().enumerate() {
                let predicted = predicted(chain, &places, Some((i, which))).0;
                let mut column = probe.column(&Source::State(state));
                forget_inputs(&program, &mut column);
                error = error.larger(difference(&column, &predicted));
            }
            let y = predicted(chain, &places, Some((i, 0))).1;
            let output = probe.output(&Source::State(place.s[0]));
            // What is next to nothing is put out as 0.
            let is_seen = output != 0.0 || (y * LARGEST).abs() > axis.ipc.v_max * 1e-12;
            error =
                error.larger(if is_seen { (output - y).abs() / output.abs().larger(f64::MIN_POSITIVE) } else { 0.0 });
        }
        // An input may reach other stages too.
        let column = probe.column(&Source::Input(chain.input));
        let mut own = vec![0.0; column.len()];
        places.iter().flat_map(|place| place.s).for_each(|s| own[s] = column[s]);
        error = error.larger(difference(&own, &predicted(chain, &places, None).0));
    }
    error
}

/// An input of the cycle before is not a state of a section.
fn forget_inputs(program: &Program, column: &mut [f64]) {
    let variables = program.state.iter().zip(column);
    variables.filter(|(variable, _)| variable.path.ends_with(".before")).for_each(|(_, value)| *value = 0.0);
}

/// What the chain says of one step from a unit of s1 (0) or of the other value (1) of section `from`, or of the input: the entries of the
/// column, and the output.
fn predicted(chain: &Chain, places: &[Place], from: Option<(usize, usize)>) -> (Vec<(usize, f64)>, f64) {
    let mut column = Vec::with_capacity(2 * places.len());
    let mut y = if from.is_none() { 1.0 } else { 0.0 };
    for (i, (place, section)) in places.iter().zip(&chain.section).enumerate() {
        let x = y;
        // p = x - low, and what p was left from is 0.
        let sign = if place.is_by_change { -1.0 } else { 1.0 };
        let mut s = [0.0; 2];
        if let Some((section, which)) = from
            && section == i
        {
            s[which] = if which == 1 { sign } else { 1.0 };
        }
        y = section.step(&mut s, x);
        let second = if place.is_by_change { x - s[1] } else { s[1] };
        column.extend([(place.s[0], s[0]), (place.s[1], second)]);
    }
    (column, chain.gain * y)
}

/// The largest difference between a column and its entries that are not 0, relative to each.
fn difference(column: &[f64], expected: &[(usize, f64)]) -> f64 {
    let entry = |(index, found): (usize, &f64)| {
        let expected = expected.iter().find(|(at, _)| *at == index).map_or(0.0, |(_, value)| *value);
        let largest = found.abs().larger(expected.abs());
        if largest > 0.0 { (found - expected).abs() / largest } else { 0.0 }
    };
    column.iter().enumerate().map(entry).fold(0.0, f64::larger)
}
