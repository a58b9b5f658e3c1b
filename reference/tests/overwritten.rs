//! Parts of the state of `ipc` that something else has overwritten, one by one (docs/parameter-sets.md, docs/improved-position-control.md).

use reference::sets;

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
