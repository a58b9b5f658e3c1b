//! The open speed plant and its controller -> the closed speed loop; the delay that the measurement does not contain.
//!
//! ```text
//! L0 = Kp (1 + 1/(j w Tn)) G        G: from current to velocity
//! P  = L0/(1 + L0) exp(-j w delay)  relative standard error: that of G / |1 + L0|
//! ```

use super::order::hz;
use super::{From, Point, Said, magnitude, turned};
use crate::codes;
use crate::number::significant;
use stability::Complex64;
use std::f64::consts::TAU;

/// A speed loop with a smaller distance from -1 is hardly the one in the drive; below the second value it certainly is not.
const NEAR: f64 = 0.25;
const OSCILLATES: f64 = 0.05;

pub(super) fn close(points: &[Point], from: From, said: &mut Said<'_>) -> Vec<Point> {
    match from {
        From::Command { delay } => points.iter().map(|point| delayed(point, delay)).collect(),
        From::Current { kp, tn, delay } => {
            let loops: Vec<Complex64> =
                points.iter().map(|point| controller(point.hz, kp, tn) * point.response).collect();
            crossing(points, &loops, said);
            let closed = points.iter().zip(&loops).map(|(point, open)| {
                let sum = 1.0 + open;
                Point { response: open / sum, error: point.error / magnitude(sum), ..*point }
            });
            closed.map(|point| delayed(&point, delay)).collect()
        }
    }
}

fn delayed(point: &Point, delay: f64) -> Point {
    Point { response: point.response * turned(-TAU * point.hz * delay), ..*point }
}

/// Kp (1 + 1/(j w Tn)).
fn controller(hz: f64, kp: f64, tn: f64) -> Complex64 {
    let integral = if tn > 0.0 { 1.0 / (TAU * hz * tn) } else { 0.0 };
    Complex64::new(kp, -kp * integral)
}

/// Checks that the loop is above 1 at the lowest line, below 1 at the highest, and at a distance from -1.
fn crossing(points: &[Point], loops: &[Complex64], said: &mut Said<'_>) {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
    let sizes: Vec<f64> = loops.iter().map(|open| magnitude(*open)).collect();
    let [lowest, highest] = [sizes[0], sizes[sizes.len() - 1]];
    if lowest < 1.0 || highest > 1.0 {
        let (point, size) = if lowest < 1.0 { (first, lowest) } else { (last, highest) };
        let found =
            format!("the open speed loop Kp (1 + 1/(s Tn)) G is {} at {} Hz", significant(size, 3), hz(point.hz));
        said.push(
            said.error(codes::SPEED_LOOP, [point.line, 0], found)
                .allowed("above 1 at the lowest line, below 1 at the highest: the loop has a crossover frequency")
                .instead("Kp in the unit of the current per unit of the velocity of this file, Tn in seconds; lines up to above the crossover"),
        );
        return;
    }
    let nearest = loops.iter().zip(points).map(|(open, point)| (magnitude(1.0 + open), point));
    let Some((distance, point)) = nearest.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(distance, _)| *distance < NEAR)
    else {
        return;
    };
    let found = format!("the speed loop comes within {} of -1 at {} Hz", significant(distance, 2), hz(point.hz));
    let place = [point.line, 0];
    let made = match distance < OSCILLATES {
        true => said.error(codes::SPEED_LOOP, place, found + ": it oscillates"),
        false => said.warning(codes::SPEED_LOOP_NEAR, place, found + ": a drive in use keeps a larger distance"),
    };
    said.push(
        made.allowed(format!("{NEAR} or more"))
            .instead("Kp and Tn as they were in the drive, in the units of this file"),
    );
}
