//! Improved position control: the stages, the limit, the gate's fade.

use super::{filter, stage};
use crate::axis::{Axis, Ipc};
use portable::{Real, RealKind};
use reference::ipc::Coeffs;

/// Coefficients of improved position control for one axis. All mathematics is done in f64 with `libm`, so that every
/// host finds the same bits; each coefficient is rounded once to `R`.
///
/// - limit = v_add_max_fact / 1000 * v_max (P-AXIS-00757, P-AXIS-00212), in the unit of v_max: um/s or 0.001 deg/s.
/// - rest = v_max * 2^-60 in double, v_max * 2^-40 in single precision: far below one increment, far above what a
///   section at rest decays to.
/// - fade: [`fade_cycles`].
#[must_use]
pub fn coefficients<R: Real>(axis: &Axis) -> Coeffs<R> {
    let ipc = &axis.ipc;
    let cycle_time = axis.cycle_time();
    let limit = limit(ipc);
    let fade_cycles = fade_cycles(axis);
    Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        enable: ipc.enable as i32,
        slave: axis.control.master.is_some(),
        stage: core::array::from_fn(|i| stage::coefficients(ipc.stage[i].as_ref(), cycle_time)),
        limit: R::lit(limit),
        lower_limit: R::lit(0.0 - limit), // not `-limit`: 0 stays +0
        rest: R::lit(ipc.v_max * rest_fraction(R::KIND)),
        fade_cycles,
        fade_step: R::lit(1.0 / f64::from(fade_cycles)),
    }
}

/// Largest |v_add|, in the unit of v_max. The product is exact for every whole v_max, so that there is one rounding.
#[must_use]
pub fn limit(ipc: &Ipc) -> f64 {
    f64::from(ipc.v_add_max_fact) * ipc.v_max / 1000.0
}

/// The part of v_max below which a sum counts as 0: 2^-60 in double, 2^-40 in single precision.
#[must_use]
pub fn rest_fraction(real: RealKind) -> f64 {
    match real {
        RealKind::F64 => libm::ldexp(1.0, -60),
        RealKind::F32 => libm::ldexp(1.0, -40),
    }
}

/// Cycles that the gate takes from 0 to 1: ceil(max(fade, one period of the lowest f0 of all active filters) / Ts), at
/// least 1.
///
/// A decimal fraction such as 0.1 s / 0.001 s is rarely exact in binary. A quotient within 1e-9 of a whole number
/// (relative) counts as that number, so that neither 100.00000000000001 becomes 101 nor a fade grows by a cycle when it
/// is written in another unit; a fade is thereby at most a part in 1e9 shorter than asked for.
///
/// # Panics
/// If there are more than 2^24 cycles, which the check excludes: beyond, f32 cannot count.
#[must_use]
pub fn fade_cycles(axis: &Axis) -> u32 {
    let quotient = fade(&axis.ipc) * 1e9 / f64::from(axis.cycle_time_ns);
    let nearest = libm::round(quotient);
    let cycles = if (quotient - nearest).abs() <= 1e-9 * quotient { nearest } else { libm::ceil(quotient) };
    assert!(cycles <= MAX_FADE_CYCLES, "design: the check lets no fade of {cycles} cycles through");
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number, 1 to 2^24")]
    {
        cycles.max(1.0) as u32
    }
}

/// The longest fade: all whole numbers up to 2^24 are exact in f32.
pub const MAX_FADE_CYCLES: f64 = 16_777_216.0;

/// Time that the gate takes from 0 to 1 [s], before it is rounded up to whole cycles.
#[must_use]
pub fn fade(ipc: &Ipc) -> f64 {
    let lowest =
        ipc.stage.iter().flatten().flat_map(|stage| &stage.filter).filter_map(filter::f0).min_by(f64::total_cmp);
    lowest.map_or(ipc.fade, |f0| ipc.fade.max(1.0 / f0))
}
