//! Which axes are refused although each of their parameters is in its range.

use crate::axis::{Axis, Filter, Mode, Prototype};
use crate::blocks::Designed;
use crate::blocks::ipc::feasibility::{Refusal, refusals};
use crate::unit::sets::axes;
use portable::RealKind;

/// An axis with one INDIRECT stage: 62.5 us, Q 10, and an all-pass beside a band-pass of order 3.
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
    assert_eq!(refused(&axis(160.0, RealKind::F32)), []);
}

#[test]
fn a_centre_that_rounding_moves_is_refused() {
    let refusals = refused(&axis(1.0, RealKind::F32));
    let moved: Vec<_> = refusals.iter().filter(|refusal| refusal.found.starts_with("centre frequency")).collect();
    assert!(moved.len() >= 3, "{refusals:?}");
    assert!(moved.iter().all(|refusal| refusal.allowed == "a difference of 0.1 %"));
    assert!(moved.iter().any(|refusal| refusal.element.to_string() == "stage[1].filter[1].bandpass[2]"), "{moved:?}");
}

/// In double precision no fade that single precision can count is long enough for that.
#[test]
fn an_unstable_section_is_refused() {
    let axis = axis(1e-3, RealKind::F32);
    let found = refused(&axis).into_iter().filter(|refusal| refusal.found.starts_with("unstable")).count();
    assert!(found >= 1, "{:?}", refused(&axis));
}
