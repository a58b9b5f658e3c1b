//! The excitation as it is designed: the register, the fade in whole cycles. No text.

use crate::axis::Axis;
use portable::Extreme;
use reference::call_rate;
use reference::excitation::Coeffs;

/// The most cycles of a fade: far fewer than single precision can count, so that no step of it is above the amplitude.
const MOST_CYCLES: f64 = 1_048_576.0;

/// Designs the excitation of an axis; all 0 where there is none.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number, 1 to 2^20")]
pub(super) fn coefficients(axis: &Axis) -> Coeffs<f64> {
    let Some(of) = &axis.excitation else { return Coeffs::default() };
    let fade_cycles = (of.at(axis.cycle_time()).fade() as f64).smaller(MOST_CYCLES);
    let bits = of.sequence.bits();
    Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        bits,
        ones: (1 << bits) - 1,
        front: 1 << (bits - 1),
        clock: of.sequence.clock(),
        periods: of.periods,
        amplitude: of.amplitude,
        fade_cycles: fade_cycles as u32,
        fade_step: of.amplitude / fade_cycles,
        call_rate: call_rate::Coeffs { active: axis.counts_calls },
    }
}
