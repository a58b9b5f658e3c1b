//! Single steps of a block against what its measured sections predict for them: nothing of the block is missing in a chain.

use super::{block, rack_and_pinion};
use crate::axis::Axis;
use crate::blocks::Designed;
use crate::blocks::ipc::certificate::chain::{Chain, measure, place};
use crate::blocks::ipc::certificate::probe::{Probe, Source};
use crate::unit::sets;
use portable::RealKind;

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
    let mut probe = Probe::new(&program, limit);
    let stages: Vec<_> = designed.stage.iter().flatten().collect();
    let mut error = 0.0_f64;
    for (chain, stage) in measure(&program, &stages, limit).iter().zip(stages) {
        let places: Vec<[usize; 2]> = stage.section.iter().map(|section| place(&program, section)).collect();
        for (i, [s1, s2]) in places.iter().enumerate() {
            error = error.max(difference(&probe.column(&Source::State(*s2)), &[(*s1, 1.0)]));
            error = error.max(difference(&probe.column(&Source::State(*s1)), &predicted(chain, &places, Some(i))));
            let predicted = chain.gain * chain.section[i + 1..].iter().map(|section| section.b0).product::<f64>();
            let output = probe.output(&Source::State(*s1));
            error = error.max((output - predicted).abs() / output.abs().max(f64::MIN_POSITIVE));
        }
        // An input may reach other stages too.
        let column = probe.column(&Source::Input(chain.input));
        let mut own = vec![0.0; column.len()];
        places.iter().flatten().for_each(|s| own[*s] = column[*s]);
        error = error.max(difference(&own, &predicted(chain, &places, None)));
    }
    error
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
