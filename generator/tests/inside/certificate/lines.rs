//! The certificate in words where the golden cases have none.

use super::{certified, rack_and_pinion};
use generator::axis::Mode;
use generator::blocks::ipc::certificate::lines;
use portable::RealKind;

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
