//! The limit: on the sum, at the output, and nowhere else.

use crate::bench::{Bench, Noise, bits, example};
use crate::in_both_real_types;
use portable::{Portable, Real};

/// The twin has a limit that it never reaches: its states are the same bits, its output shows what was cut off.
fn it_cuts_the_sum_and_leaves_the_filters_alone<R: Real>() {
    let (mut block, mut twin, mut noise) = (example::<R>(), example::<R>(), Noise::default());
    let limit = R::lit(300.0);
    (block.coeffs.limit, block.coeffs.lower_limit) = (limit, -limit);
    let (mut above, mut below, mut within) = (0, 0, 0);
    for _ in 0..5_000 {
        let v = noise.next();
        let (found, free) = (block.at(v), twin.at(v));
        let sum = free.v_add_calculated;
        let expected = match sum {
            sum if sum > limit => limit,
            sum if sum < -limit => -limit,
            sum => sum,
        };
        assert_eq!(bits(found.v_add_calculated), bits(expected));
        assert_eq!(found.limited, bits(expected) != bits(sum));
        assert!(!free.limited && !found.fault, "reaching the limit is not a fault");
        assert_eq!(leaves(&block), leaves(&twin));
        above += u32::from(sum > limit);
        below += u32::from(sum < -limit);
        within += u32::from(!found.limited);
    }
    assert!(above > 100 && below > 100 && within > 100, "{above} above, {below} below, {within} within");
}

fn limit_0_mutes_the_block<R: Real>() {
    let (mut block, mut noise) = (example::<R>(), Noise::default());
    (block.coeffs.limit, block.coeffs.lower_limit) = (R::ZERO, R::ZERO);
    block.at(noise.next());
    for _ in 0..500 {
        let outputs = block.at(noise.next());
        assert_eq!((bits(outputs.v_add), bits(outputs.v_add_calculated), outputs.limited), (0, 0, true));
    }
}

/// The bits of all states.
fn leaves<R: Real>(block: &Bench<R>) -> Vec<String> {
    let mut leaves = Vec::new();
    block.state.visit(&mut |leaf| leaves.push(format!("{leaf:?}")));
    leaves
}

in_both_real_types! {
    it_cuts_the_sum_and_leaves_the_filters_alone
    limit_0_mutes_the_block
}
