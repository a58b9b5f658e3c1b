//! Conditions that the controller reports and corrects: a warning with its number, and the corrected value.

use super::{drive, effective::Effective};
use crate::parameters::words::{FeedforwardWord, Words};
use crate::parameters::{Name, Value, path_with, time_text};
use crate::{axis::Ratio, config::values::key, diagnostics::Diagnostic};

/// Every delay is shorter than this number of cycles.
pub(crate) const DELAY_CYCLES: u64 = 6;

/// A delay in us; it is 0 if it is outside of 0 to below six cycles (70348, 70349).
pub(crate) fn delay(
    e: &mut Effective<'_>,
    name: Name,
    cycle_time: Option<u32>,
    (code, id): (&'static str, u32),
) -> Option<u32> {
    let given = match e.written(key(name)) {
        Some(value) => value.clone(),
        // A value that is not a number is an ordinary error.
        None => e.validated(key(name))?,
    };
    let Value::Integer(us) = given else { return None };
    let end = cycle_time.map_or(u64::MAX, |ns| DELAY_CYCLES * u64::from(ns));
    let is_within = |us: &u32| u64::from(*us) * 1000 < end;
    let delay = u32::try_from(us).ok().filter(is_within).unwrap_or_else(|| {
        let cycle = cycle_time.map_or(String::new(), |ns| format!(", {} each", time_text(u64::from(ns))));
        let found =
            format!("{} is {us} us: error {id} of the controller; the delay is corrected to 0", e.title(key(name)));
        let allowed = format!("0 <= {} < {DELAY_CYCLES} cycles{cycle} [us]", name.parameter().short());
        e.report.push(Diagnostic::warning(code, e.place_of(key(name)), found).allowed(allowed));
        0
    });
    if delay > u32::from(u16::MAX) {
        // Six long cycles exceed the parameter's own range, which the controller does not correct.
        return e.validated(key(name)).and(None);
    }
    e.note(key(name), &Value::Integer(i64::from(delay)));
    Some(delay)
}

/// A quotient whose denominator may be 0; `consequence` then describes the result.
pub(crate) fn ratio(
    e: &mut Effective<'_>,
    [num, denom]: [Name; 2],
    code: &'static str,
    (consequence, corrected): (&str, Option<u32>),
) -> Option<Ratio> {
    if e.written(key(denom)) != Some(&Value::Integer(0)) {
        return drive::ratio(e, key(num), key(denom));
    }
    let numerator = e.integer(key(num));
    let found = format!("{} is 0: {consequence}", e.title(key(denom)));
    let allowed = format!("1 <= {}", denom.parameter().short());
    e.report.push(Diagnostic::warning(code, e.place_of(key(denom)), found).allowed(allowed));
    e.note(key(denom), &Value::Integer(i64::from(corrected.unwrap_or(0))));
    Some(corrected.map_or(Ratio::ZERO, |denom| Ratio { num: numerator.unwrap_or(0), denom }))
}

/// An additive output without process data is switched off (70350, 70351).
pub(crate) fn no_datum(e: &mut Effective<'_>, word: FeedforwardWord, datum: Name, (code, id): (&'static str, u32)) {
    let found = format!(
        "{} has {}, and the process data have no such command: error {id} of the controller; the output is switched off",
        e.title(key(Name::FeedforwardMode)),
        word.name()
    );
    let instead =
        format!("{} = \"INT32\" or \"INT16\" in a set, if the drive has it", path_with(datum.parameter().path, [0, 0]));
    e.warn(code, key(Name::FeedforwardMode), found, instead);
}
