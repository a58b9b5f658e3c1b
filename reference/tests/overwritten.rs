//! Parts of the state of `ipc` that something else has overwritten, one by one (docs/parameter-sets.md, docs/improved-position-control.md).

#![expect(clippy::float_cmp, reason = "a number that was copied is that number")]

use reference::{ipc, sets};

/// A pause that no refusal leads to is none: a set is looked at, and not after 2^32 cycles only.
#[test]
fn a_pause_beyond_the_fade_is_none() {
    let mut coeffs = sets::Coeffs::<f64>::default();
    coeffs.ipc.fade_cycles = 20;
    let is_paused = |pause: u32| {
        let mut state = sets::State::<f64>::default();
        (state.pause, state.refused, state.refused_set, state.offered_set) = (pause, 7, 5, 5);
        sets::is_paused(&state, &coeffs)
    };
    assert_eq!([0, 1, 20, 21, u32::MAX].map(is_paused), [false, true, true, false, false]);
}

/// A tuned part of the limit that was overwritten never leads beyond the limit.
#[test]
fn an_overwritten_part_of_the_limit_stays_within_the_limit() {
    let mut coeffs = ipc::Coeffs::<f64>::default();
    coeffs.tuning.active = true;
    (coeffs.limit, coeffs.lower_limit, coeffs.sum_limit, coeffs.fade_cycles) = (10.0, -10.0, 100.0, 20);
    for part in [3.0, 1e300, f64::INFINITY, f64::NAN, -4.0] {
        for v_sum in [5.0, 20.0, -20.0, 99.0, -99.0, 1e30, f64::NAN] {
            let (mut state, mut outputs) = (ipc::State::<f64>::default(), ipc::Outputs::<f64>::default());
            state.tuning.limit.now = part;
            let v_limited = ipc::limit(&mut state, &mut outputs, &coeffs, v_sum);
            assert!((-10.0..=10.0).contains(&v_limited), "part {part}, sum {v_sum}: {v_limited}");
            assert!(v_limited == 0.0 || v_limited == v_sum || state.fade > 20, "part {part}, sum {v_sum}: {v_limited}");
        }
    }
}
