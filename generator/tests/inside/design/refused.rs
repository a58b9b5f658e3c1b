//! Which axes are refused although each of their parameters is in its range.

use crate::inside::sets::axes;
use generator::axis::{Axis, Filter, Mode, Prototype};
use generator::blocks::Designed;
use generator::blocks::ipc::feasibility::{Refusal, refusals, refusals_of};
use generator::blocks::ipc::stage::stage;
use portable::RealKind;

/// An axis with one INDIRECT stage: 62.5 us, Q 10, and an all-pass next to a band-pass of order 3.
fn axis(f0: f64, real: RealKind) -> Axis {
    let mut axis = axes(1, real).next().expect("one axis");
    axis.cycle_time_ns = 62_500;
    let mut stage = axis.ipc.stage[0].take().expect("the first axis has a first stage");
    stage.mode = Mode::Indirect { osc_damping: 0.8 };
    stage.filter = [
        Filter::Allpass { f0, q_factor: 10.0 },
        Filter::Bandpass { prototype: Prototype::Butterworth, order: 3, f0, q_factor: 10.0 },
    ];
    axis.ipc.stage = [None, Some(stage), None];
    axis
}

fn refused(axis: &Axis) -> Vec<Refusal> {
    refusals(&Designed::from(axis.clone()))
}

#[test]
fn axes_in_range_are_not_refused() {
    for axis in axes(1_000, RealKind::F64).chain(axes(1_000, RealKind::F32)) {
        assert_eq!(refused(&axis), [], "{axis:?}");
    }
    assert_eq!(refused(&axis(0.1, RealKind::F64)), []);
}

/// From the lowest f0 Ts that a fade can count, 1 / 2^24, to 0.45.
#[test]
fn single_precision_keeps_every_centre() {
    for f0 in [1e-3, 0.016, 1.0, 2.0, 10.0, 160.0, 500.0, 7_200.0] {
        assert_eq!(refused(&axis(f0, RealKind::F32)), [], "{f0}");
    }
}

/// Of a stage that no check has seen: in double precision no fade that can be counted is long enough for it.
fn refused_at(f0: f64) -> Vec<Refusal> {
    let axis = axis(f0, RealKind::F64);
    let of = axis.ipc.stage[1].as_ref().expect("the stage of the axis");
    refusals_of(&stage(1, of, axis.cycle_time()), RealKind::F64)
}

#[test]
fn a_centre_that_rounding_moves_is_refused() {
    let refusals = refused_at(2.5e-4);
    let moved: Vec<_> = refusals.iter().filter(|refusal| refusal.found.starts_with("centre frequency")).collect();
    assert!(moved.len() >= 3, "{refusals:?}");
    assert!(moved.iter().all(|refusal| refusal.allowed == "a difference of 0.1 %"));
    assert!(moved.iter().any(|refusal| refusal.element.to_string() == "stage[1].filter[1].bandpass[2]"), "{moved:?}");
}

#[test]
fn an_unstable_section_is_refused() {
    let refusals = refused_at(1e-7);
    let found = refusals.iter().filter(|refusal| refusal.found.starts_with("unstable")).count();
    assert!(found >= 1, "{refusals:?}");
}

/// A damping ratio that single precision cannot tell from 0: where A C = B, or more.
#[test]
fn an_oscillation_without_damping_is_refused_in_single_precision() {
    let refused = (1..50).flat_map(|i| {
        let mut axis = axis(100.0 * f64::from(i), RealKind::F32);
        let stage = axis.ipc.stage[1].as_mut().expect("the stage of the axis");
        stage.mode = Mode::Indirect { osc_damping: 1e-9 };
        refused(&axis)
    });
    let refused: Vec<_> = refused.collect();
    assert!(refused.len() > 10, "{refused:?}");
    for Refusal { element, found, allowed, .. } in refused {
        assert!(found.starts_with("unstable with its coefficients in single precision: A = "), "{found}");
        assert_eq!((element.to_string().as_str(), allowed.as_str()), ("stage[1].oscillation", "0 < A C < B < 2"));
    }
}
