//! The rows of the commissioning page: fractions of the designed weight and of the limit, as inputs and as parameters. No
//! text.

use crate::axis::{Ipc, Stage};
use crate::number::{decimals, digits, significant};
use stability::MAX_MS;

/// The steps, as parts of the designed value [%]: small ones first, because they already show mistakes.
pub(super) const PARTS: [u32; 6] = [10, 20, 40, 60, 80, 100];

/// A step as a factor.
pub(super) fn part(percent: u32) -> f64 {
    f64::from(percent) / 100.0
}

/// The largest numerator and denominator of a weight (P-AXIS-00754/00755).
const LARGEST: u64 = 4_294_967_294;

/// A step of a weight.
pub(super) struct Row {
    /// the value of the input
    pub(super) part: String,
    /// the resulting weight
    pub(super) weight: String,
    /// the weight as parameters
    pub(super) num: u64,
    pub(super) denom: u64,
    /// the part of the vibration that remains with the drive of the page [%]
    pub(super) left: String,
    /// largest |S| of the loop with the drive of the page, and whether it is too large
    pub(super) ms: String,
}

/// The effect of a part of a weight, with the drive that the set states or an ideal one.
pub(super) struct Step {
    /// remaining part of the vibration
    pub(super) left: f64,
    /// largest |S| of the loop; `None` if the stage closes no loop
    pub(super) ms: Option<f64>,
}

/// A step of the limit.
pub(super) struct Limit {
    /// the value of the input
    pub(super) part: String,
    /// [um/s or 0.001 deg/s]
    pub(super) limit: String,
    /// the limit as a parameter
    pub(super) v_add_max_fact: u32,
}

/// The steps of a weight, each with its effect, `None` if the loop oscillates; such a row is left out.
pub(super) fn rows(stage: &Stage, steps: [Option<Step>; PARTS.len()]) -> Vec<Row> {
    let row = |(percent, step): (u32, Option<Step>)| {
        let [num, denom] = weight(stage, percent);
        let (part, Step { left, ms }) = (part(percent), step?);
        let ms = match ms {
            Some(ms) if ms > MAX_MS => format!("{}, little reserve", decimals(ms, 1)),
            Some(ms) => decimals(ms, 1),
            None => "-".to_owned(),
        };
        Some(Row {
            part: digits(part),
            weight: significant(stage.weight() * part, 4),
            num,
            denom,
            left: decimals(left * 100.0, 0),
            ms,
        })
    };
    PARTS.into_iter().zip(steps).filter_map(row).collect()
}

/// A part [%] of a weight as numerator and denominator, with the denominator of the parameters if possible.
fn weight(stage: &Stage, percent: u32) -> [u64; 2] {
    let capped = stage.asked_weight() > Stage::MAX_WEIGHT;
    let [num, denom] = if capped { [7, 1] } else { [stage.weight_fact_num.into(), stage.weight_fact_denom.into()] };
    let percent = u64::from(percent);
    if num * percent % 100 == 0 {
        return [num * percent / 100, denom];
    }
    let divisor = gcd(num * percent, denom * 100);
    let [num, denom] = [num * percent / divisor, denom * 100 / divisor];
    if num <= LARGEST && denom <= LARGEST { [num, denom] } else { millionths(stage.weight() * percent as f64 / 100.0) }
}

/// The nearest whole number of millionths of a weight, at least one.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a weight is above 0 and at most 7")]
fn millionths(weight: f64) -> [u64; 2] {
    [(libm::round(weight * 1e6) as u64).max(1), 1_000_000]
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The steps of the limit; empty if it is 0. A tuned limit is a part of the designed one; a generated one is a whole number
/// of parts of vb_max.
pub(super) fn limits(ipc: &Ipc) -> Vec<Limit> {
    let row = |percent: u32| {
        let v_add_max_fact = (ipc.v_add_max_fact * percent).div_ceil(100);
        let part = part(percent);
        let limit = match ipc.tuning() {
            Some(_) => ipc.limit() * part,
            None => ipc.limit_with(v_add_max_fact),
        };
        Limit { part: digits(part), limit: digits(limit), v_add_max_fact }
    };
    let mut rows: Vec<Limit> = PARTS.map(row).into();
    rows.dedup_by(|next, row| next.limit == row.limit);
    rows.retain(|row| row.v_add_max_fact > 0);
    rows
}
