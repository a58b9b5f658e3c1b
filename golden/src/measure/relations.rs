//! Results from channels with a known relation: the delay of one of them, units that contradict it, and the gain of the
//! position controller. No response.

use super::record::{OF_VELOCITY, Record, rate, smoothed};
use super::unit::is_near;
use super::verdict::Verdict;
use generator::codes;
use identification::offset::{self, Time};
use portable::{Extreme, peak};
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
/// A smaller gain is unusual.
const LOW_KV: f64 = 4.0;
/// A velocity fits the change of a position within that factor.
const FITS: f64 = 1.2;

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

/// Whether the stated velocity of the motor is the change of a stated position, where it is fast and their ratio is steady.
pub(super) fn positions_fit(record: &Record, verdicts: &mut Vec<Verdict>) -> bool {
    let stated = |name: &str| record.channel(name).filter(|channel| channel.is_stated && channel.unit.is_some());
    let position = ["x_actual", "x_command"].into_iter().find_map(stated);
    let Some((x, motor)) = position.zip(stated("v_motor")) else { return true };
    let smooth = |values: &[f64]| smoothed(values, OF_VELOCITY / record.cycle);
    let (change, speed) = (smooth(&rate(&x.values, record.cycle)), smooth(&motor.values));
    let (ratio_of_units, least) = (motor.ratio_to(x), peak(&speed) / 2.0);
    let fast = speed.iter().zip(&change).filter(|(speed, _)| libm::fabs(**speed) > least);
    let mut ratios: Vec<f64> = fast.map(|(speed, change)| ratio_of_units * libm::fabs(speed / change)).collect();
    ratios.sort_by(f64::total_cmp);
    let part = |quarters: usize| ratios.get(ratios.len() * quarters / 4).copied();
    let (Some(low), Some(ratio), Some(high)) = (part(1), part(2), part(3)) else { return true };
    if high > FITS * low || (1.0 / FITS..FITS).contains(&ratio) {
        return true;
    }
    let found =
        format!("v_motor is {ratio:.3} times as large as the change of {}, in the units that are stated", x.signal);
    verdicts.push(Verdict::refusal(codes::UNITS_DIFFER, found, "export scaled values, or correct the units"));
    false
}

/// Reports an assumed unit of the following error with which the gain of the position controller is a tenth of the known one,
/// or unusual if none is known: the CNC counts positions in 0.1 um.
pub(crate) fn find_error_unit(record: &Record, known: Option<f64>, verdicts: &mut Vec<Verdict>) {
    let assumed = record.channel("following_error").filter(|error| !error.is_stated).and_then(|error| error.unit);
    let is_wrong = |kv: &f64| known.map_or(*kv < LOW_KV, |known| *kv >= LOW_KV && is_near(10.0 * kv / known));
    let kv = position_gain(record).or_else(|| gain_alone(record)).filter(is_wrong);
    let Some((unit, kv)) = assumed.zip(kv) else { return };
    let found = format!("following_error has no unit: {} are assumed, with which Kv is {kv:.2}/s", unit.name);
    let instead = "state its unit, as in `following_error [0.1 um]`";
    verdicts.push(Verdict::note(codes::ASSUMED_UNIT, found, instead));
}

/// Kv [1/s] from `v_command = Kv e`, as [`position_gain`].
fn gain_alone(record: &Record) -> Option<f64> {
    let (command, error) = record.channel("v_command").zip(record.channel("following_error"))?;
    let units = command.unit?.size / error.unit?.size;
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let [yy, ye, ee] = [(command, command), (command, error), (error, error)].map(|(a, b)| sum(&a.values, &b.values));
    (ee > 0.0 && yy - ye * ye / ee < LEFT * LEFT * yy).then(|| units * ye / ee)
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
