//! The measured response against the designed one, and what it sees of a wrong block.

use super::{block, certified, one_band_pass, rack_and_pinion};
use crate::inside::sets;
use generator::axis::{Axis, Prototype};
use generator::blocks::Designed;
use generator::blocks::ipc::certificate::{certify, largest_defect};
use portable::{Extreme, Literal, RealKind};

/// Relative tolerances that the definition gives against an independent implementation.
#[test]
fn in_double_precision_measured_is_designed() {
    for set in sets::sets(400) {
        let axis = one_band_pass(RealKind::F64, set.cycle_time_ns, set.prototype, set.order, set.f0, set.q_factor);
        let found = certified(&axis).deviation().expect("measured");
        let allowed = match set.product {
            product if product >= 6e-4 => 1e-9,
            product if product >= 6e-5 => 1e-7,
            _ => 1e-5,
        };
        assert!(found <= allowed, "{found:e}: {set:?}");
    }
}

/// Up to three stages, all modes and filters, f0 Ts at least 0.01 in double precision. A coefficient is rounded to 1e-16 or 6e-8; in
/// double precision a quality factor of 20 and a centre of 2 pi f0 Ts = 0.06 magnify that by up to 20 / 0.06 in each of up to
/// seven sections. In single precision the centre does not matter; far above its own f0 the oscillation is 1 less a rounded 1.
#[test]
fn of_whole_blocks_too() {
    for (real, allowed) in [(RealKind::F64, 1e-11), (RealKind::F32, 1e-3)] {
        for axis in sets::axes(150, real).filter(|axis| axis.ipc.v_add_max_fact > 0) {
            let certificate = certified(&axis);
            let found = certificate.deviation().expect("measured");
            assert!(found <= allowed, "{found:e}: {axis:?}");
        }
    }
}

/// How near a response comes to what `generate` refuses, of filters alone and of whole blocks: a fifth at most.
#[test]
fn what_rounding_costs_is_a_fifth_of_what_is_refused_at_most() {
    let alone = |real| {
        sets::sets(400)
            .map(move |set| one_band_pass(real, set.cycle_time_ns, set.prototype, set.order, set.f0, set.q_factor))
    };
    for real in [RealKind::F64, RealKind::F32] {
        let mut largest: f64 = 0.0;
        for axis in alone(real).chain(sets::axes(300, real)).filter(|axis| axis.ipc.v_add_max_fact > 0) {
            let designed = Designed::from(axis);
            if !generator::blocks::ipc::feasibility::refusals(&designed).is_empty() {
                continue;
            }
            let certificate = certified(&designed.axis);
            certificate.refuse(&designed).unwrap();
            for band in &certificate.response {
                let design = designed.stage[band.stage].as_ref().unwrap();
                for point in &band.points {
                    let part = point.defect() / largest_defect(design, real);
                    largest = largest.larger(part);
                }
            }
        }
        assert!(largest < 0.2, "{real:?}: {largest}");
    }
}

/// Each coefficient, one after the other, one per cent larger in the compiled block.
#[test]
fn a_coefficient_that_is_off_by_one_per_cent_is_seen() {
    let axis = rack_and_pinion(RealKind::F64);
    let program = block(&axis).program;
    let mut changed = 0;
    for index in 0..program.constants.len() {
        let constant = &program.constants[index];
        let Literal::F64(value) = constant.value else { continue };
        if !constant.path.starts_with("stage") || constant.path.contains("preset") {
            continue;
        }
        let mut wrong = program.clone();
        wrong.constants[index].value = Literal::F64(value * 1.01);
        let deviation = certify(&Designed::from(axis.clone()), &wrong).deviation().expect("measured");
        assert!(deviation > 1e-3, "{}: {deviation:e}", program.constants[index].path);
        let designed = Designed::from(axis.clone());
        assert_eq!(certify(&designed, &wrong).refuse(&designed).unwrap_err().pass, "certificate");
        changed += 1;
    }
    assert!(changed >= 11, "{changed}");
}

#[test]
fn a_limit_of_0_is_said_and_nothing_is_measured() {
    let mut axis = rack_and_pinion(RealKind::F64);
    axis.ipc.v_add_max_fact = 0;
    let certificate = certified(&axis);
    assert_eq!(certificate.deviation(), None);
    assert!(certificate.bound.state > 1.0);
    let lines = generator::blocks::ipc::certificate::lines(&certificate);
    assert!(
        lines[0].starts_with("range: the limit is 0, v_add is always 0; |v| <= 530000 um/s gives no |state| above ")
    );
    assert_eq!(lines[1], "response: not measured, a limit of 0 mutes the block (P-AXIS-00757)");
}

/// The smallest limits and the largest: the clamp never acts, nor what makes a small sum 0.
#[test]
fn it_does_not_depend_on_the_limit() {
    let mut random = sets::Random(7);
    for number in 0..64_usize {
        let real = if number.is_multiple_of(2) { RealKind::F32 } else { RealKind::F64 };
        let axis = |v_add_max_fact, v_max| -> Axis {
            let mut axis = one_band_pass(real, 1_000_000, Prototype::Bessel, 3, 53.0, 10.0);
            axis.ipc.v_add_max_fact = v_add_max_fact;
            axis.ipc.v_max = v_max;
            axis
        };
        let of = |axis: Axis| certified(&axis).deviation().expect("measured");
        let fact = u32::try_from(1 + random.below(2000)).expect("at most 2000");
        let v_max = 1.0 + 2e9 * random.unit();
        let [found, usual] = [of(axis(fact, v_max)), of(axis(1000, 530_000.0))];
        let allowed = if real == RealKind::F32 { 1e-6 } else { 1e-14 };
        assert!((found - usual).abs() <= allowed, "{fact} {v_max}: {found:e} {usual:e}");
    }
}
