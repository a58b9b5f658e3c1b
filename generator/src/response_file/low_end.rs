//! Checks of the lowest lines: a motor follows slow commands exactly, an open speed plant integrates. They reveal a
//! position, another unit, the other sign and another response.

use super::units::NEAR_ONE;
use super::{From, Point, Said, degrees};
use crate::codes;
use crate::number::{decibels, decimals, significant};
use stability::{Complex64, magnitude};
use std::f64::consts::TAU;

/// Ratios of usual units of velocities: rpm, 1/s, rad/s, deg/s, mm/s, m/s, m/min.
const RATIOS: [(f64, &str); 6] = [
    (60.0, "60, as between a minute and a second"),
    (60.0 / TAU, "9.55, as between rpm and rad/s"),
    (1000.0, "1000, as between m and mm"),
    (TAU, "6.28, as between revolutions and radians"),
    (360.0, "360, as between revolutions and degrees"),
    (1000.0 / 60.0, "16.7, as between m/min and mm/s"),
];
/// A speed loop has a larger bandwidth [Hz].
const SLOW: f64 = 10.0;

/// The lowest lines: their median, and its change up to three times their frequency.
struct LowEnd {
    place: [usize; 2],
    response: Complex64,
    error: f64,
    /// [dB/decade]; `None` if the lines do not reach three times the lowest frequency
    slope: Option<f64>,
}

impl LowEnd {
    fn of(points: &[Point]) -> Option<Self> {
        let first = points.first()?;
        let lowest = middle(&points[..points.len().min(3)])?;
        let at = points.partition_point(|point| point.hz < 3.0 * first.hz);
        let above = points.get(at).and_then(|_| middle(&points[at..points.len().min(at + 3)]));
        let slope = above.map(|above| {
            let change = decibels(magnitude(above.response) / magnitude(lowest.response));
            change / libm::log10(above.hz / lowest.hz)
        });
        Some(Self { place: [first.line, 0], response: lowest.response, error: lowest.error, slope })
    }

    fn falls(&self) -> bool {
        self.slope.is_some_and(|slope| (-26.0..=-14.0).contains(&slope))
    }

    fn is_flat(&self) -> bool {
        self.slope.is_none_or(|slope| slope.abs() < 6.0)
    }
}

/// The line with the median magnitude.
fn middle(points: &[Point]) -> Option<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| magnitude(a.response).total_cmp(&magnitude(b.response)));
    sorted.get(sorted.len() / 2).copied()
}

pub(super) fn check(points: &[Point], names: [usize; 2], from: From, said: &mut Said<'_>) {
    let Some(low) = LowEnd::of(points) else { return };
    match from {
        From::Command { .. } => {
            command(&low, said);
            if !said.report.has_errors() {
                slow(points, names, said);
            }
        }
        From::Current { .. } => current(&low, said),
    }
}

/// Checks that P is 1 at low frequencies.
fn command(low: &LowEnd, said: &mut Said<'_>) {
    let [size, angle] = [magnitude(low.response), degrees(low.response)];
    let margin = 1.0 + 2.0 * low.error;
    let is_one = NEAR_ONE[0] / margin <= size && size <= NEAR_ONE[1] * margin;
    let both = format!("{} at {} deg", significant(size, 3), decimals(angle, 0));
    if low.falls() && (angle + 90.0).abs() < 30.0 {
        said.push(
            said.error(codes::INTEGRATES, low.place, format!("{both} at the lowest lines, and it falls by 20 dB a decade: it integrates"))
                .allowed("the motor's velocity over the commanded velocity: 1 at 0 deg at the lowest lines")
                .instead(
                    "the response of the velocity, not of the position; an open speed plant, from current to velocity, needs the speed \
                     controller's Kp and Tn; if it is a slow response, a measurement that begins lower",
                ),
        );
    } else if !is_one {
        let ratio =
            RATIOS.iter().find(|(ratio, _)| [size, 1.0 / size].iter().any(|size| (size / ratio - 1.0).abs() < 0.07));
        let instead = match ratio {
            Some((_, words)) if low.is_flat() => format!("both velocities in one unit: the factor is near {words}"),
            _ => "both velocities in one unit and on one side of the gear; not a control deviation, not an open loop; lines that begin lower"
                .to_owned(),
        };
        said.push(
            said.error(codes::NOT_ONE, low.place, format!("{both} at the lowest lines"))
                .allowed(format!("a magnitude of {} to {}: a motor follows slow commands", NEAR_ONE[0], NEAR_ONE[1]))
                .instead(instead),
        );
    } else if angle.abs() > 120.0 {
        said.push(
            said.error(
                codes::NOT_ONE,
                low.place,
                format!("{both} at the lowest lines: one of the velocities has the other sign"),
            )
            .allowed("0 deg at the lowest lines: a motor follows slow commands")
            .instead("the other sign of one of them, which turns every phase by 180 deg"),
        );
    }
}

/// Warns of a bandwidth that only position loops have.
fn slow(points: &[Point], names: [usize; 2], said: &mut Said<'_>) {
    let Some(last) = points.iter().rfind(|point| magnitude(point.response) >= 0.5_f64.sqrt()) else { return };
    if last.hz < SLOW && points.last().is_some_and(|point| point.hz > 2.0 * SLOW) {
        let found = format!(
            "a bandwidth of {} Hz, as a position loop with Kv = {}/s has it",
            significant(last.hz, 3),
            kv(last.hz)
        );
        said.push(
            said.warning(codes::SLOW_RESPONSE, names, found)
                .allowed("from the commanded velocity to the motor's")
                .instead("the response of the velocity, measured with the position loop open or at its input"),
        );
    }
}

fn kv(hz: f64) -> String {
    significant(TAU * hz, 2)
}

/// Checks that the velocity of an open plant falls with the frequency, because a current accelerates.
fn current(low: &LowEnd, said: &mut Said<'_>) {
    let [size, angle] = [magnitude(low.response), degrees(low.response)];
    let is_one = (NEAR_ONE[0]..=NEAR_ONE[1]).contains(&size);
    if is_one && angle.abs() < 30.0 && low.slope.is_some() && low.is_flat() {
        let found =
            format!("{} at {} deg at the lowest lines: a closed loop", significant(size, 3), decimals(angle, 0));
        said.push(
            said.error(codes::CLOSED_LOOP, low.place, found)
                .allowed(
                    "the open speed plant, from current to velocity: it falls by 20 dB a decade at the lowest lines",
                )
                .instead("the response as one from the commanded velocity, without Kp and Tn"),
        );
    }
}
