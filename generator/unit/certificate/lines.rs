//! The certificate in words.

use super::{certified, rack_and_pinion};
use crate::axis::Mode;
use crate::blocks::ipc::certificate::lines;
use portable::RealKind;

#[test]
fn of_the_rack_and_pinion_example() {
    let axis = rack_and_pinion(RealKind::F64);
    let lines = lines(&certified(&axis));
    assert_eq!(
        lines,
        [
            "range: |v| <= 530000 um/s gives |v_add| <= 2308249 before the limit and no |state| above 783998.6; for |v| <= 1e15: \
             4.355187e15, within double precision",
            "stage[0] at 53 Hz: designed 3 at 180 deg, measured 3 at 180 deg; at 50.41374 Hz: designed 2.12132 at -135 deg, \
             measured 2.12132 at -135 deg; at 55.71374 Hz: designed 2.12132 at 135 deg, measured 2.12132 at 135 deg",
            "stage[1] at 11 Hz: designed 2.240571 at 147.9946 deg, measured 2.240571 at 147.9946 deg; at 8.588009 Hz: \
             designed 1.642602 at -156.3142 deg, measured 1.642602 at -156.3142 deg; at 14.08801 Hz: designed 1.42671 at \
             91.62457 deg, measured 1.42671 at 91.62457 deg",
            "largest deviation of measured from designed: 7.8e-15",
        ]
    );
}

#[test]
fn of_single_precision() {
    let axis = rack_and_pinion(RealKind::F32);
    let lines = lines(&certified(&axis));
    assert!(lines[0].ends_with("within single precision"), "{}", lines[0]);
    assert_eq!(
        lines[4],
        "signal-to-noise ratio in single precision, of a vibration of 1060 at f0 while the axis moves at 530000 um/s: \
         stage[0] 129 dB, stage[1] 93 dB"
    );
}

/// A damping ratio of 1e-7 in single precision: the oscillation is stable, and its roundings may add up without end.
#[test]
fn where_nothing_is_certain_that_is_said() {
    let mut axis = rack_and_pinion(RealKind::F32);
    if let Some(stage) = &mut axis.ipc.stage[1] {
        stage.mode = Mode::Indirect { osc_damping: 1e-7 };
    }
    let lines = lines(&certified(&axis));
    assert_eq!(
        lines[0],
        "range: no guaranteed bound, because a section is so weakly damped that its rounding errors can accumulate"
    );
}
