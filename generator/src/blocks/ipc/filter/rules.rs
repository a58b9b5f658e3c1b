//! The rule that applies to all types of filters.

use crate::parameters::{Name, real_text, time_text};
use crate::rules::effective::Effective;
use crate::{codes, number::rounded};
use reference::design::inputs::{LARGEST_SHARE, highest_f0, share};

/// The frequency, whose upper bound depends on the cycle time.
pub(super) fn f0(e: &mut Effective<'_>, index: [u32; 2], cycle_time: Option<u32>) -> Option<f64> {
    let key = (Name::FilterF0, index);
    let f0 = e.real(key)?;
    let Some(ns) = cycle_time else { return Some(f0) };
    let highest = highest_f0(ns);
    if f0 > highest {
        let (f0_ts, largest, time) = (share(f0, ns), LARGEST_SHARE, time_text(u64::from(ns)));
        let highest = (highest * 1e3).floor() / 1e3;
        let found = format!("{} is {} Hz, {} of the sampling frequency", e.title(key), real_text(f0), rounded(f0_ts));
        let allowed = format!("fg_f0 <= {highest} Hz at a cycle time of {time} ({largest} of the sampling frequency)");
        e.refuse(codes::NYQUIST, key, found, [Some(allowed), None]);
        return None;
    }
    Some(f0)
}
