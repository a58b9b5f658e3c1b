//! Numbers as in controllers: angles within a turn, positions and velocities on a grid. No state.

/// A full turn [0.001 deg].
pub const TURN: f64 = 360_000.0;

/// A position on the grid of 0.0001 deg or 0.1 um.
#[must_use]
pub fn position(x: f64) -> f64 {
    (x * 10.0).round() / 10.0 + 0.0
}

/// A velocity, an acceleration or a jerk on the grid of its unit.
#[must_use]
pub fn rate(v: f64) -> f64 {
    v.round() + 0.0
}

/// An angle within a turn, on the grid.
#[must_use]
pub fn angle(x: f64) -> f64 {
    let x = position(x.rem_euclid(TURN));
    if x >= TURN { 0.0 } else { x }
}

/// A distance in the shorter direction.
#[must_use]
pub fn shortest(distance: f64) -> f64 {
    let within = distance.rem_euclid(TURN);
    if within > TURN / 2.0 { within - TURN } else { within }
}
