//! Whether the lines cover the band of an active stage, in steps that are fine enough and with sufficient certainty.

use super::numbers::Line;
use super::order::hz;
use super::{Band, Point, Said, degrees, turned};
use crate::codes;
use crate::number::{decimals, significant};
use portable::Extreme;
use std::f64::consts::TAU;

/// Two standard errors of a magnitude from which a response contains no information.
const NOTHING: f64 = 0.5;
/// Below this part of the lowest f0 a stage hardly acts.
const SLOW: f64 = 0.2;
/// The coherence at which four averages, the usual minimum, contain no information.
const LOW_COHERENCE: f64 = 2.0 / 3.0;
/// P turns by at most this angle [deg] between two lines, or a curve through them shows nothing of what is between.
const TURN: f64 = 30.0;
/// What makes the lines denser.
const FINER: &str = "a measurement with a finer resolution: a longer one, or a smaller bandwidth";

/// `dead_time`: of the response, if known [s].
pub(super) fn check(points: &[Point], lines: &[Line], bands: &[Band], dead_time: Option<f64>, said: &mut Said<'_>) {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
    for band in bands {
        let [from, to] = [band.f0 - 0.5 * band.width, band.f0 + 0.5 * band.width];
        if from < first.hz || to > last.hz {
            let (line, side) = if from < first.hz { (first, "begins") } else { (last, "ends") };
            let found =
                format!("the response {side} at {} Hz, stage[{}] has f0 {} Hz", hz(line.hz), band.stage, hz(band.f0));
            said.push(
                said.error(codes::NOT_REACHED, [line.line, 0], found)
                    .allowed(format!(
                        "lines from {} Hz to {} Hz at least: f0 and its half-power width",
                        hz(from),
                        hz(to)
                    ))
                    .instead("a measurement over that range"),
            );
            continue;
        }
        if 2.0 * band.f0 > last.hz {
            let found =
                format!("the response ends at {} Hz, stage[{}] has f0 {} Hz", hz(last.hz), band.stage, hz(band.f0));
            said.push(
                said.warning(codes::ENDS_EARLY, [last.line, 0], found)
                    .allowed("up to twice f0: a loop is mostly lost above f0; beyond the last line its value holds"),
            );
        }
        let above = points.partition_point(|point| point.hz <= band.f0).clamp(1, points.len() - 1);
        if is_fine(band, [&points[above - 1], &points[above]], said) {
            turning(band, points, dead_time.unwrap_or(0.0), said);
        }
        certainty(band, [&points[above - 1], &points[above]], [&lines[above - 1], &lines[above]], said);
    }
}

/// Leaves out lines that contain no information at frequencies at which no stage acts: the loop is that of the position
/// controller there, which runs on the machine, and with them it would count as unstable. A warning.
pub(super) fn with_information(points: Vec<Point>, bands: &[Band], said: &mut Said<'_>) -> Vec<Point> {
    let slow = SLOW * bands.iter().map(|band| band.f0).fold(f64::INFINITY, f64::smaller);
    let is_used = |point: &Point| slow.is_infinite() || point.hz >= slow || 2.0 * point.error < NOTHING;
    let (used, left_out): (Vec<Point>, Vec<Point>) = points.into_iter().partition(is_used);
    if let [first, .., last] | [first @ last] = &left_out[..] {
        let found = format!(
            "two standard errors are half of the magnitude or more at {} lines from {} Hz to {} Hz, which are left out",
            left_out.len(),
            hz(first.hz),
            hz(last.hz)
        );
        said.push(
            said.warning(codes::SLOW_UNCERTAIN, [first.line, 0], found)
                .allowed(format!("below {} %", 100.0 * NOTHING))
                .instead("a measurement with more averages, a larger excitation, or while the axis moves"),
        );
    }
    used
}

/// Whether no vibration with the bandwidth of the stage can be hidden between two lines at f0.
fn is_fine(band: &Band, [below, above]: [&Point; 2], said: &mut Said<'_>) -> bool {
    let distance = above.hz - below.hz;
    if distance <= 0.25 * band.width {
        return true;
    }
    let found = format!("{} Hz between lines at f0 of stage[{}], {} Hz", hz(distance), band.stage, hz(band.f0));
    let allowed = format!("at most {} Hz, a quarter of the half-power width f0/Q", hz(0.25 * band.width));
    let place = [above.line, 0];
    said.push(match distance > band.width {
        true => said.error(codes::GAP, place, found).allowed(allowed).instead(FINER),
        false => said.warning(codes::COARSE, place, found).allowed(allowed).instead(FINER),
    });
    false
}

/// A resonance of the drive that is narrower than the lines: within a width of f0, P turns too much between two of them, beyond
/// its dead time [s] and two standard errors.
fn turning(band: &Band, points: &[Point], dead_time: f64, said: &mut Said<'_>) {
    let inside =
        points.windows(2).filter(|pair| pair[1].hz > band.f0 - band.width && pair[0].hz < band.f0 + band.width);
    let turn = |pair: &[Point]| {
        let [below, above] = pair else { return 0.0 };
        let late = turned(TAU * (above.hz - below.hz) * dead_time);
        let uncertain = 2.0 * (below.error + above.error).to_degrees();
        degrees(above.response / below.response * late).abs() - uncertain
    };
    let largest = inside.map(|pair| (turn(pair), pair)).reduce(|a, b| if b.0 > a.0 { b } else { a });
    let Some((angle, [below, above])) = largest.filter(|(angle, _)| *angle > TURN) else { return };
    let found = format!(
        "the response turns by at least {} degrees from {} Hz to {} Hz, near f0 of stage[{}], {} Hz",
        decimals(angle, 0),
        hz(below.hz),
        hz(above.hz),
        band.stage,
        hz(band.f0)
    );
    said.push(
        said.warning(codes::COARSE, [above.line, 0], found)
            .allowed(format!("at most {TURN} degrees between two lines, beyond the dead time and two standard errors"))
            .instead(FINER),
    );
}

/// Warns of an uncertain response at f0, from which no margin can be computed.
fn certainty(band: &Band, points: [&Point; 2], lines: [&Line; 2], said: &mut Said<'_>) {
    let place = [points[1].line, 0];
    let double = 2.0 * points[0].error.larger(points[1].error);
    let lowest = lines.iter().filter_map(|line| line.coherence).fold(f64::INFINITY, f64::smaller);
    let of_stage = format!("at f0 of stage[{}], {} Hz", band.stage, hz(band.f0));
    let coherence = if lowest.is_finite() { format!(", coherence {}", decimals(lowest, 2)) } else { String::new() };
    let instead = "a measurement with more averages, a larger excitation, or while the axis moves";
    if double >= NOTHING {
        let found = format!(
            "two standard errors are {} % of the magnitude {of_stage}{coherence}",
            significant(100.0 * double, 2)
        );
        let allowed = format!("below {} %", 100.0 * NOTHING);
        said.push(said.error(codes::UNCERTAIN, place, found).allowed(allowed).instead(instead));
    } else if double <= 0.0 && lowest < LOW_COHERENCE {
        let found = format!("a coherence of {} {of_stage}", decimals(lowest, 2));
        let allowed = format!("{} or more, as long as the number of averages is unknown", decimals(LOW_COHERENCE, 2));
        said.push(said.warning(codes::LOW_COHERENCE, place, found).allowed(allowed).instead(instead));
    }
}
