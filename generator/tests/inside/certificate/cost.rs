//! What a certificate costs.

use super::{block, one_band_pass, rack_and_pinion};
use crate::inside::sets;
use generator::axis::Prototype;
use generator::blocks::Designed;
use generator::blocks::ipc::certificate::certify;
use portable::RealKind;
use std::time::Instant;

/// Says how long; fails only where something is out of all proportion, also in a build for tests on a slow host.
#[test]
fn it_is_bounded_at_the_lowest_frequency_too() {
    let slow = one_band_pass(RealKind::F64, 62_500, Prototype::Butterworth, 3, 0.016, 10.0);
    let most = sets::axes(200, RealKind::F64).max_by_key(|axis| block(axis).program.state.len()).expect("one");
    for (name, axis) in [("usual", rack_and_pinion(RealKind::F64)), ("slow", slow), ("most", most)] {
        let (designed, block) = (Designed::from(axis.clone()), block(&axis));
        let once = |_| {
            let start = Instant::now();
            std::hint::black_box(certify(&designed, &block.program));
            start.elapsed()
        };
        let each = (0..100).map(once).min().expect("100 runs"); // what else the host does only adds
        assert!(each.as_millis() < 20, "{name}: {each:?}, {} variables of the state", block.program.state.len());
    }
}
