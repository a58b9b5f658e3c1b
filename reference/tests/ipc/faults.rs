//! Where the block must not act: 0 at once, the right number, and after it a block like a new one.

use crate::bench::{Bench, Noise, all_bits, direct, example, simulated};
use crate::in_both_real_types;
use portable::Real;
use reference::signal::sample_limit;
use reference::stage::{DirectSource, Mode};

/// Something that stops the block: how to bring it about, and its number.
type Stop<R> = (fn(&mut Bench<R>), u32);

fn stops<R: Real>() -> [Stop<R>; 9] {
    [
        (|block| block.inputs.reset = true, 0),
        (|block| block.inputs.position_controlled = false, 0),
        (|block| block.inputs.task_cycle_ns = 1_000_001, 1),
        (|block| block.inputs.task_cycle_ns = 1, 1),
        (|block| block.inputs.mode = 3, 2),
        (|block| block.inputs.mode = -1, 2),
        (|block| block.inputs.v_motor = R::lit(f64::NAN), 12),
        (|block| block.inputs.v_motor = R::lit(f64::NEG_INFINITY), 12),
        (|block| block.inputs.v_motor = R::lit(1e38), 12),
    ]
}

/// For one cycle or many, then the reason goes.
fn the_output_is_0_at_once_and_the_block_starts_anew<R: Real>() {
    for ((stop, error_id), length) in stops::<R>().into_iter().flat_map(|stop| [(stop, 1), (stop, 50)]) {
        let (mut block, mut noise) = (example::<R>().running(), Noise::default());
        assert!(block.at(noise.next()).v_add != R::ZERO, "it is acting");
        let before = block.inputs;
        stop(&mut block);
        for _ in 0..length {
            assert_eq!(all_bits(&block.step()), (0, 0, false, error_id != 0, error_id));
            assert_eq!(block.state.fade, 0);
        }
        block.inputs = before;
        let mut fresh = example::<R>();
        for cycle in 0..500 {
            let v = noise.next();
            assert_eq!(all_bits(&block.at(v)), all_bits(&fresh.at(v)), "error {error_id}, cycle {cycle} after it");
        }
    }
}

/// While the reset lasts the states follow the input, so that a velocity that came meanwhile does not shake the axis.
fn a_reset_is_a_level_and_the_states_follow_the_input<R: Real>() {
    let (mut block, mut noise) = (Bench::<R>::new(&[direct()]).running(), Noise::default());
    block.inputs.reset = true;
    for _ in 0..200 {
        assert_eq!(all_bits(&block.at(noise.next())), (0, 0, false, false, 0));
    }
    let v = R::lit(123_456.5);
    block.at(v);
    block.inputs.reset = false;
    for _ in 0..2_000 {
        assert_eq!(all_bits(&block.at(v)), (0, 0, false, false, 0));
    }
}

/// Of two reasons the first in the order samples, cycle time, state, mode is reported.
fn reasons_have_an_order<R: Real>() {
    let nan = R::lit(f64::NAN);
    let mut from_load = direct::<R>();
    from_load.direct_source = DirectSource::Direct;
    let mut block = Bench::new(&[simulated(Mode::SetPoint), simulated(Mode::Indirect), from_load]);
    (block.inputs.v_command, block.inputs.v_motor, block.inputs.v_direct) = (nan, nan, nan);
    block.inputs.mode = 7;
    block.inputs.task_cycle_ns = 5;
    block.inputs.reset = true;
    assert_eq!(block.step().error_id, 11);
    block.inputs.v_command = R::ONE;
    assert_eq!(block.step().error_id, 12);
    block.inputs.v_motor = R::ONE;
    assert_eq!(block.step().error_id, 13);
    block.inputs.v_direct = R::ONE;
    assert_eq!(block.step().error_id, 1);
    block.inputs.task_cycle_ns = 1_000_000;
    block.state.fade = u32::MAX;
    assert_eq!(block.step().error_id, 3);
    assert_eq!(block.step().error_id, 2);
    block.inputs.mode = 1;
    assert_eq!(all_bits(&block.step()), (0, 0, false, false, 0));
}

/// Whatever the caller wants: one cycle reports it, then the block is like a new one.
fn an_overwritten_fade_is_a_fault<R: Real>() {
    for (mode, slave) in [(0, false), (1, false), (2, false), (0, true)] {
        for (beyond, position_controlled, reset) in
            [(1, true, false), (u32::MAX, true, false), (1, false, false), (1, true, true)]
        {
            let (mut block, mut fresh, mut noise) = (example::<R>().running(), example::<R>(), Noise::default());
            for of in [&mut block, &mut fresh] {
                (of.coeffs.slave, of.inputs.mode) = (slave, mode);
                (of.inputs.position_controlled, of.inputs.reset) = (position_controlled, reset);
            }
            block.state.fade = block.coeffs.fade_cycles.saturating_add(beyond);
            assert_eq!(all_bits(&block.at(noise.next())), (0, 0, false, true, 3), "mode {mode}");
            assert_eq!((block.state.fade, block.state.preset), (0, false));
            for cycle in 0..500 {
                let v = noise.next();
                assert_eq!(all_bits(&block.at(v)), all_bits(&fresh.at(v)), "mode {mode}, cycle {cycle} after it");
            }
        }
    }
}

/// A velocity that no stage looks at may be anything.
fn only_what_a_stage_reads_is_judged<R: Real>() {
    let mut from_load = direct::<R>();
    from_load.direct_source = DirectSource::Direct;
    for stage in [direct(), from_load, simulated(Mode::Indirect), simulated(Mode::SetPoint)] {
        let (mut block, mut twin, mut noise) = (Bench::new(&[stage]), Bench::new(&[stage]), Noise::default());
        for _ in 0..500 {
            let v = noise.next();
            let read = |is_read| if is_read { v } else { R::lit(f64::NAN) };
            let is_direct = stage.mode == Mode::Direct;
            block.inputs.v_command = read(stage.mode == Mode::SetPoint);
            block.inputs.v_direct = read(is_direct && stage.direct_source == DirectSource::Direct);
            block.inputs.v_motor =
                read(stage.mode == Mode::Indirect || is_direct && stage.direct_source == DirectSource::Motor);
            assert_eq!(all_bits(&block.step()), all_bits(&twin.at(v)));
        }
    }
}

/// The limit itself is a good sample, the next number is not, on both sides.
fn the_sample_limit_is_exact<R: Real>() {
    let limit: R = sample_limit();
    let beyond = limit + limit * R::per_kind(f64::EPSILON, f32::EPSILON);
    assert!(beyond > limit);
    for (v, error_id) in [(limit, 0), (-limit, 0), (beyond, 12), (-beyond, 12)] {
        let mut block = example::<R>();
        assert_eq!(block.at(v).error_id, error_id, "{v}");
        assert_eq!(block.at(v).fault, error_id != 0, "{v}");
    }
}

in_both_real_types! {
    the_output_is_0_at_once_and_the_block_starts_anew
    a_reset_is_a_level_and_the_states_follow_the_input
    reasons_have_an_order
    an_overwritten_fade_is_a_fault
    only_what_a_stage_reads_is_judged
    the_sample_limit_is_exact
}
