//! The design of improved position control: its stages, the limits of their sum, the fade. It is designed once.

use super::stage::{StageDesign, stage};
use crate::axis::{Axis, Ipc, Stage};
use portable::Extreme;
use portable::RealKind;
use reference::call_rate;
use reference::design::limit::{lower_limit, sum_limit};
use reference::ipc::{Coeffs, STAGES, ride_through, tuning, watch};

/// Designs improved position control of an axis; an inactive stage is `None`. The coefficients are in double precision;
/// single precision rounds each of them once. A section has the coefficients of both real types; a block uses its own.
///
/// - limit = v_add_max_fact / 1000 * v_max (P-AXIS-00757, P-AXIS-00212), in the unit of v_max: um/s or 0.001 deg/s.
/// - sum_limit: [`sum_limit`].
/// - rest = v_max * 2^-60 in double, v_max * 2^-40 in single precision: far below one increment, far above the values that a
///   section at rest decays to.
/// - fade: [`fade_cycles`].
/// - watch: [`watch`].
pub fn design(axis: &Axis) -> ([Option<StageDesign>; STAGES], Coeffs<f64>) {
    let ipc = &axis.ipc;
    let (limit, fade_cycles) = (ipc.limit(), fade_cycles(axis));
    let stages: [Option<StageDesign>; STAGES] =
        std::array::from_fn(|i| Some(stage(i, ipc.stage[i].as_ref()?, axis.cycle_time())));
    let coeffs = Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        enable: ipc.enable as i32,
        slave: axis.control.master.is_some(),
        stage: stages.each_ref().map(|stage| stage.as_ref().map_or_else(Default::default, |stage| stage.coeffs)),
        limit,
        lower_limit: lower_limit(limit),
        sum_limit: sum_limit(stages.iter().flatten().map(|stage| stage.norm).sum(), limit, ipc.v_max),
        rest: libm::ldexp(ipc.v_max, rest_exponent(axis.real)),
        fade_cycles,
        fade_step: 1.0 / f64::from(fade_cycles),
        tuning: ipc.tuning().map_or_else(Default::default, |start| tuning::Coeffs {
            active: true,
            weight: start.weight,
            limit: start.limit,
        }),
        ride_through: ride_through::Coeffs { active: ipc.ride_through > 0, cycles: ipc.ride_through },
        watch: watch(axis),
        call_rate: call_rate::Coeffs { active: axis.counts_calls },
    };
    (stages, coeffs)
}

/// A block of the watch lasts 0.6 periods of the lowest f0: delay makes a loop oscillate above its f0, usually at 1.2 to 2
/// f0, so that a block contains both crests. Below 30 ms the blocks of a burst that decays in 0.3 s would look alike.
const BLOCK_PERIODS: f64 = 0.6;
const SHORTEST_BLOCK: f64 = 0.03;
/// Smallest number of cycles of a block, so that it contains the crests.
const FEWEST_CYCLES: f64 = 8.0;
/// The vibration must reach the limit for this time [s] and this number of blocks: the vibration after a blow has decayed by
/// then.
const ALARM_TIME: f64 = 0.15;
const FEWEST_BLOCKS: f64 = 3.0;

/// The watch over the loop. With the limit 0 there is nothing to watch, and on a gantry slave neither. In a parameter set the
/// limit 0 is a number like another one: the structure stays, so that a block takes the set.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole numbers, at most 2^24")]
fn watch(axis: &Axis) -> watch::Coeffs<f64> {
    let (ipc, limit) = (&axis.ipc, axis.ipc.limit());
    let lowest = ipc.lowest_f0().or_else(|| ipc.stage.iter().flatten().map(Stage::f0).min_by(f64::total_cmp));
    let acts = (limit > 0.0 || ipc.takes_sets()) && axis.control.master.is_none();
    let Some(f0) = lowest.filter(|_| ipc.watch && acts) else { return watch::Coeffs::default() };
    // A quotient that differs from a whole number only by its rounding is that number.
    let whole = |quotient: f64| libm::ceil(quotient * (1.0 - 1e-9));
    let block = whole((BLOCK_PERIODS / f0).larger(SHORTEST_BLOCK) / axis.cycle_time()).larger(FEWEST_CYCLES);
    let blocks = whole(ALARM_TIME / (block * axis.cycle_time())).larger(FEWEST_BLOCKS);
    let (block_cycles, alarm) = (block as u32, 2 * blocks as u32);
    watch::Coeffs { active: true, block_cycles, alarm, quiet: watch::quiet(limit) }
}

/// The part of v_max below which a sum counts as 0, as a power of 2.
pub fn rest_exponent(real: RealKind) -> i32 {
    if real == RealKind::F64 { -60 } else { -40 }
}

/// Cycles of the whole fade: ceil(fade time / Ts), at least 1.
///
/// A decimal fraction such as 0.1 s / 0.001 s is rarely exact in binary. A quotient within 1e-9 of a whole number (relative)
/// counts as that number, so that 100.00000000000001 does not become 101, and a fade does not depend on the unit in which it
/// is written. A fade is thereby at most a part of 1e-9 shorter than specified.
///
/// # Panics
/// If there are more than 2^24 cycles, which the check excludes: beyond, f32 cannot count.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number, 1 to 2^24")]
pub fn fade_cycles(axis: &Axis) -> u32 {
    let quotient = axis.ipc.fade_time() * 1e9 / f64::from(axis.cycle_time_ns);
    let nearest = libm::round(quotient);
    let cycles = if (quotient - nearest).abs() <= 1e-9 * quotient { nearest } else { libm::ceil(quotient) };
    assert!(cycles <= Ipc::MAX_FADE_CYCLES, "design: the check lets no fade of {cycles} cycles through");
    cycles.larger(1.0) as u32
}
