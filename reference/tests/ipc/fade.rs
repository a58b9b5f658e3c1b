//! The fade: how it moves, and that nothing else moves with it.

use crate::bench::{Bench, FADE_CYCLES, Noise, all_bits, bits, example};
use crate::in_both_real_types;
use portable::Real;
use reference::ipc::{mode_dryrun, mode_off, mode_on};

/// `v_add = fade * v_add_calculated`, and nothing but the fade's whole steps.
fn assert_fade<R: Real>(block: &mut Bench<R>, noise: &mut Noise, position: u32) {
    let outputs = block.at(noise.next());
    let fade = R::from_u32(position) * block.coeffs.fade_step;
    assert_eq!(block.state.fade, position);
    let expected = match position {
        0 => R::ZERO,
        FADE_CYCLES => outputs.v_add_calculated,
        _ => outputs.v_add_calculated * fade,
    };
    assert_eq!(bits(outputs.v_add), bits(expected), "fade at {position}");
    assert!(outputs.v_add_calculated != R::ZERO);
}

fn it_moves_linearly_and_turns_round<R: Real>() {
    let (mut block, mut noise) = (example::<R>(), Noise::default());
    assert_eq!(bits(block.at(noise.next()).v_add), 0, "the first cycle is that of the preset");
    for position in 1..=FADE_CYCLES {
        assert_fade(&mut block, &mut noise, position);
    }
    for _ in 0..50 {
        assert_fade(&mut block, &mut noise, FADE_CYCLES);
    }
    block.inputs.mode = mode_dryrun();
    for position in (40..FADE_CYCLES).rev() {
        assert_fade(&mut block, &mut noise, position);
    }
    block.inputs.mode = mode_on();
    for position in 41..=80 {
        assert_fade(&mut block, &mut noise, position);
    }
    block.inputs.mode = mode_dryrun();
    for position in (0..80).rev().chain([0; 50]) {
        assert_fade(&mut block, &mut noise, position);
    }
    block.inputs.mode = mode_on();
    assert_fade(&mut block, &mut noise, 1);
}

/// The twin stays in ON: whatever the mode of the other one, its filters are in the same state.
fn dryrun_never_resets_a_filter<R: Real>() {
    let (mut block, mut twin, mut noise) = (example::<R>(), example::<R>(), Noise::default());
    for _ in 0..20_000 {
        let v = noise.next();
        let (found, expected) = (block.at(v), twin.at(v));
        assert_eq!(bits(found.v_add_calculated), bits(expected.v_add_calculated));
        if noise.bits() >> 27 == 0 {
            block.inputs.mode = if block.inputs.mode == mode_on() { mode_dryrun() } else { mode_on() };
        }
    }
}

/// Off for a shorter time than the fade takes to 0, and the filters run on; for that time or longer, and the block
/// restarts: exactly there.
fn off_resets_the_filters_where_it_has_faded_out<R: Real>() {
    for off in 1..=2 * FADE_CYCLES {
        let (mut block, mut twin) = (example::<R>().running(), example::<R>().running());
        let mut fresh = example::<R>();
        let mut noise = Noise::default();
        block.inputs.mode = mode_off();
        twin.inputs.mode = mode_dryrun();
        for cycle in 1..=off {
            let v = noise.next();
            let (found, expected) = (block.at(v), twin.at(v));
            assert_eq!(bits(found.v_add), bits(expected.v_add), "fades out alike, cycle {cycle}");
            assert_eq!(bits(found.v_add_calculated), 0, "OFF shows nothing");
        }
        block.inputs.mode = mode_on();
        twin.inputs.mode = mode_on();
        for cycle in 0..3 {
            let v = noise.next();
            let (found, running, started) = (block.at(v), twin.at(v), fresh.at(v));
            let expected = if off < FADE_CYCLES { &running } else { &started };
            assert_eq!(all_bits(&found), all_bits(expected), "{off} cycles off, cycle {cycle}");
        }
    }
}

fn off_puts_out_nothing<R: Real>() {
    let (mut block, mut noise) = (example::<R>(), Noise::default());
    block.inputs.mode = mode_off();
    for _ in 0..500 {
        assert_eq!(all_bits(&block.at(noise.next())), (0, 0, false, false, 0));
    }
}

in_both_real_types! {
    it_moves_linearly_and_turns_round
    dryrun_never_resets_a_filter
    off_resets_the_filters_where_it_has_faded_out
    off_puts_out_nothing
}
