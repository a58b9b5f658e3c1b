//! The filters in their block: preset, summed, at rest.

use crate::bench::{Bench, Noise, bits, direct, example, simulated};
use crate::in_both_real_types;
use portable::{Literal, Portable, Real};
use reference::ipc::Outputs;
use reference::stage::{DirectSource, Mode};

const VELOCITIES: [f64; 8] = [0.0, 1.0, -1.0, 0.1, 1e-20, 530_000.0, -123_456.789, 9.9e8];

/// Switched on while the axis moves at a constant velocity: not the last bit of an output.
fn a_constant_velocity_gives_exactly_0_after_a_band_pass<R: Real>() {
    for v in VELOCITIES.map(R::lit) {
        let mut block = Bench::<R>::new(&[direct()]);
        for cycle in 0..5_000 {
            let Outputs { v_add, v_add_calculated, .. } = block.at(v);
            assert_eq!((bits(v_add), bits(v_add_calculated)), (0, 0), "{v}, cycle {cycle}");
        }
    }
}

/// After a simulated oscillation what remains in double precision is rounding; in single precision the oscillation sees no
/// change.
fn a_constant_velocity_gives_next_to_nothing_after_an_oscillation<R: Real>() {
    let least = R::per_kind(1e-12, 0.0);
    for (v, mode) in VELOCITIES.into_iter().flat_map(|v| [(R::lit(v), Mode::Indirect), (R::lit(v), Mode::SetPoint)]) {
        let mut block = Bench::<R>::new(&[simulated(mode)]);
        for cycle in 0..5_000 {
            let found = block.at(v).v_add_calculated;
            let magnitude = if v < R::ZERO { -v } else { v };
            assert!(-(least * magnitude) <= found && found <= least * magnitude, "{v}, cycle {cycle}: {found}");
        }
    }
}

/// v_sum = v_stage[0] + v_stage[1] + v_stage[2], in this order, each from its own source.
fn the_stages_are_summed_in_their_order<R: Real>() {
    let mut from_load = direct::<R>();
    from_load.direct_source = DirectSource::Direct;
    let stages = [from_load, simulated(Mode::SetPoint), simulated(Mode::Indirect)];
    let (mut block, mut noise) = (Bench::new(&stages), Noise::default());
    let mut single = stages.map(|stage| Bench::new(&[stage]));
    for _ in 0..2_000 {
        block.inputs.v_command = noise.next();
        block.inputs.v_motor = noise.next();
        block.inputs.v_direct = noise.next();
        let [first, second, third] = single.each_mut().map(|single| {
            single.inputs = block.inputs;
            single.step().v_add_calculated
        });
        assert_eq!(bits(block.step().v_add_calculated), bits(first + second + third));
    }
}

/// After a move the axis stands still: the output becomes exactly +0 and stays there, and no state, on the way or at the
/// end, is a subnormal number.
fn rest_is_exactly_0_without_subnormal_numbers<R: Real>() {
    let mut block = example::<R>().running();
    block.at(R::lit(1e5));
    let mut moving = 0;
    for cycle in 0..20_000 {
        if bits(block.at(R::ZERO).v_add) != 0 {
            moving = cycle;
        }
        block.state.visit(&mut |leaf| assert!(is_normal_or_0(leaf), "cycle {cycle}: {leaf:?}"));
    }
    assert!((500..10_000).contains(&moving), "at rest after {moving} cycles");
}

fn is_normal_or_0(leaf: Literal) -> bool {
    match leaf {
        Literal::F64(value) => value == 0.0 || value.is_normal(),
        Literal::F32(value) => value == 0.0 || value.is_normal(),
        _ => true,
    }
}

in_both_real_types! {
    a_constant_velocity_gives_exactly_0_after_a_band_pass
    a_constant_velocity_gives_next_to_nothing_after_an_oscillation
    the_stages_are_summed_in_their_order
    rest_is_exactly_0_without_subnormal_numbers
}
