//! Delays in whole cycles and a fraction of one.

use reference::delay::{Coeffs, LONGEST};

/// A delay of d us as N + f cycles (P-AXIS-00389, 00390, 00547). Both quotients are of whole nanoseconds: rounded once.
///
/// # Panics
/// If the delay has six cycles or more, which the check excludes.
pub fn delay(us: u32, cycle_time_ns: u32) -> Coeffs<f64> {
    let (ns, cycle) = (u64::from(us) * 1000, u64::from(cycle_time_ns));
    let whole = usize::try_from(ns / cycle).expect("design: the check lets no long delay through");
    assert!(whole < LONGEST, "design: the check lets no delay of {whole} cycles through");
    let rest = u32::try_from(ns % cycle).expect("design: less than a cycle");
    let share = |part: u32| f64::from(part) / f64::from(cycle_time_ns);
    Coeffs { whole, fractional: rest > 0, now: share(cycle_time_ns - rest), before: share(rest) }
}

/// A delay of whole cycles.
///
/// # Panics
/// If there are more cycles than a number can count.
pub fn whole(cycles: u32) -> Coeffs<f64> {
    let whole = usize::try_from(cycles).expect("design: a few cycles");
    Coeffs { whole, fractional: false, now: 1.0, before: 0.0 }
}
