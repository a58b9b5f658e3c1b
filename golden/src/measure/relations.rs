//! Results from channels with a known relation: the delay of one of them, and the gain of the position controller. No
//! response.

use super::record::{Record, rate};
use super::verdict::Verdict;
use generator::codes;
use identification::offset::{self, Time};
use portable::Extreme;
use stability::Complex64;
use std::f64::consts::TAU;

/// An offset counts if it exceeds this part of a cycle, and this number of standard errors.
const LATE: f64 = 0.25;
const ERRORS: f64 = 3.0;
/// The least error of the time between a position and its velocity, in cycles. Within a cycle a drive may take the velocity
/// anywhere: the difference of two positions is half a cycle older than the velocity at their end.
const WITHIN: f64 = 0.25;
/// Limits of Kv [1/s], and of its residual of `v_command`, as a part.
const KV: [f64; 2] = [1.0, 500.0];
const LEFT: f64 = 0.05;

/// The delay of one channel relative to another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Offset {
    pub of: &'static str,
    pub to: &'static str,
    /// `None` if the recording does not determine it
    pub time: Option<Time>,
}

/// The offsets of all pairs with a known relation: a position and its velocity, or one velocity twice.
pub(super) fn offsets(record: &Record, verdicts: &mut Vec<Verdict>) -> Vec<Offset> {
    let cycle = record.cycle;
    let mut found = Vec::new();
    if let Some((x, v)) = record.get("x_actual").zip(record.get("v_motor")) {
        // The change of a position in a cycle is the mean of its velocity over that cycle: (1 - exp(-j w T)) / (j w T).
        let mean = |hz: f64| {
            let angle = TAU * hz * cycle;
            let (sin, cos) = libm::sincos(angle);
            Complex64::new(1.0 - cos, sin) / Complex64::new(0.0, angle)
        };
        let time = offset::between(v, &rate(x, cycle), cycle, mean);
        let time = time.map(|time| Time { error: time.error.larger(WITHIN * cycle), ..time });
        found.push(Offset { of: "x_actual", to: "v_motor", time });
    }
    if let Some((command, v_cmd)) = record.get("v_command").zip(record.get("v_cmd"))
        && record.get("v_add").is_none()
        && record.get("v_excite").is_none()
    {
        let time = offset::between(command, v_cmd, cycle, |_| Complex64::new(1.0, 0.0));
        found.push(Offset { of: "v_cmd", to: "v_command", time });
    }
    for Offset { of, to, time } in &found {
        let Some(time) = time else { continue };
        if libm::fabs(time.seconds) > (LATE * cycle).larger(ERRORS * time.error) {
            let ms = [time.seconds, time.error].map(|seconds| seconds * 1e3);
            let text = format!("{of} is {:.3} +-{:.3} ms later than {to}", ms[0], ms[1]);
            verdicts.push(Verdict::note(codes::CHANNEL_LATE, text, "record both in the task of the block"));
        }
    }
    found
}

/// Kv [1/s] from `v_command = Kv e + k v_planned`, least squares; `None` if channels or units are unknown, or if the
/// channels do not determine it.
pub(super) fn position_gain(record: &Record) -> Option<f64> {
    let (command, x) = record.channel("v_command").zip(record.channel("x_command"))?;
    let (v_unit, x_unit, error_unit) = (command.unit?.size, x.unit?.size, record.unit("following_error")?.size);
    let error = record.following_error()?;
    let planned = rate(&x.values, record.cycle);
    let rows = || {
        command
            .values
            .iter()
            .zip(error.iter().zip(&planned))
            .map(|(y, (e, v))| [y * v_unit, e * error_unit, v * x_unit])
    };
    let sum = |of: fn([f64; 3]) -> f64| rows().map(of).sum::<f64>();
    let [ee, ev, vv] = [sum(|[_, e, _]| e * e), sum(|[_, e, v]| e * v), sum(|[_, _, v]| v * v)];
    let [ye, yv, yy] = [sum(|[y, e, _]| y * e), sum(|[y, _, v]| y * v), sum(|[y, ..]| y * y)];
    let determinant = ee * vv - ev * ev;
    let [kv, k] = [(ye * vv - yv * ev) / determinant, (yv * ee - ye * ev) / determinant];
    let left: f64 = rows().map(|[y, e, v]| y - kv * e - k * v).map(|left| left * left).sum();
    (determinant > 0.0 && (KV[0]..=KV[1]).contains(&kv) && left < LEFT * LEFT * yy).then_some(kv)
}
