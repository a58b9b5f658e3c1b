//! The measured velocity of a spindle that the block does not move yet. No command.

use super::state::{Coeffs, Seen};
use portable::{Real, portable, within};

/// The median of this sample and the two before it.
#[portable]
pub fn median<R: Real>(seen: &Seen<R>, v_actual: R) -> R {
    let mut low = seen.v_last;
    let mut high = seen.v_before;
    if seen.v_before < seen.v_last {
        low = seen.v_before;
        high = seen.v_last;
    }
    let below_high = if v_actual < high { v_actual } else { high };
    if below_high < low { low } else { below_high }
}

/// The velocity is unknown.
#[portable]
pub fn forget<R: Real>(seen: &mut Seen<R>) {
    seen.samples = 0u32;
    seen.slow = 0u32;
}

/// Takes a sample of the actual velocity.
#[portable]
pub fn look<R: Real>(seen: &mut Seen<R>, coeffs: &Coeffs<R>, v_actual: R) {
    if seen.samples == 0u32 {
        seen.v_last = v_actual;
        seen.v_before = v_actual;
    }
    let v_middle = median(seen, v_actual);
    seen.v = v_middle;
    seen.v_before = seen.v_last;
    seen.v_last = v_actual;
    if seen.samples < 3u32 {
        seen.samples += 1u32;
    }
    if !within(v_actual, coeffs.v_taken_up) {
        seen.slow = 0u32;
    } else if seen.slow < 3u32 {
        seen.slow += 1u32;
    }
}

/// The velocity of the spindle; 0 within the window.
#[portable]
pub fn turns_with<R: Real>(seen: &Seen<R>, coeffs: &Coeffs<R>) -> R {
    if within(seen.v, coeffs.window) { R::ZERO } else { seen.v }
}
