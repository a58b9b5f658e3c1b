//! Parts of weights and limit that something else has overwritten (docs/decisions/ipc.md).

#![expect(clippy::float_cmp, reason = "a part is 0, or a step of the ramp")]

use reference::ipc::tuning::{Factor, follow};

/// A corrupted factor starts at 0 and returns along the ramp: it must not act in full for a cycle.
#[test]
fn a_part_that_was_overwritten_comes_back_from_0() {
    for now in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.0 + f64::EPSILON, -1e30, -1.0, -0.5, -1e-9] {
        let mut part = Factor { now };
        assert!(!follow(&mut part, 1.0, 0.125, false));
        assert_eq!(part.now, 0.125, "{now}");
        let mut part = Factor { now };
        assert!(follow(&mut part, f64::NAN, 0.125, false), "the input is held");
        assert_eq!(part.now, 0.0, "{now}");
    }
}
