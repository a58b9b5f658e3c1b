//! The pictures of the manual's examples (ISG FCT-D2, "Feedforward control", Fig. 3 to 5): position lag over a move. What is drawn,
//! not how.

use crate::simulation::{Bench, KV, run};
use golden::svg::{Across, Curve, Over, Panel, Part, Picture, Point};
use machine::seven_phases::{Move, seconds};
use machine::velocity_loop::Loop;

/// Draws them.
pub const COMMAND: &str = "cargo run --release -p axgen-tests --example feedforward_pictures";

/// 0.5 m/s (30 m/min), 2.5 m/s^2, 25 m/s^3.
const MOVE: Move = Move { jerk: 25e6, change: 100_000, acceleration: 100_000, velocity: 400_000 };

/// um/s in 1 m/min.
const UM_S: f64 = 1e6 / 60.0;

/// A quarter of a second after the move the lag has come to rest.
const UNTIL_NS: u64 = 1_250_000_000;

/// Cycle time [ns].
const CYCLE_NS: u32 = 1_000_000;

/// A second-order drive: of one of first order, as the manual models it, VEL ACC would leave nothing but what the hold adds.
const DRIVE: Loop = Loop::Pt2 { t2: 2.4e-3 };

/// Its Ta without the hold's half cycle [ns].
const DRIVE_NS: u32 = 3_500_000;

const SETUP: &str = "cycle 1 ms, second-order drive (Ta 4 ms, T2 2.4 ms); 30 m/min, 2.5 m/s², 25 m/s³";

/// The files and what is in them.
#[must_use]
pub fn all() -> Vec<(&'static str, String)> {
    let pictures = [
        ("lag-without-feedforward.svg", "Position lag without feedforward", ""),
        ("lag-with-velocity.svg", "Position lag with velocity feedforward (VEL)", "vorsteuerung = \"VEL\""),
        (
            "lag-with-velocity-and-acceleration.svg",
            "Position lag with velocity and acceleration feedforward (VEL ACC)",
            "vorsteuerung = \"VEL ACC\"\nvs_a_faktor = 4000",
        ),
    ];
    pictures.map(|(name, title, feedforward)| (name, picture(title, feedforward))).into()
}

fn picture(title: &str, feedforward: &str) -> String {
    let bench = Bench { cycle_ns: CYCLE_NS, feedforward, percentage: 100, drive: DRIVE, drive_ns: DRIVE_NS };
    let samples = run(&bench, &MOVE, UNTIL_NS + 1);
    let largest = samples.iter().fold(0.0, |largest, sample| f64::max(largest, sample.lag.abs()));
    let lag: Vec<Point> = samples.iter().step_by(2).map(|sample| (seconds(sample.ns), sample.lag)).collect();
    let velocity = samples.iter().step_by(5).map(|sample| (seconds(sample.ns), sample.v / UM_S)).collect();
    let panels = vec![
        Panel::curves(format!("position lag [µm], largest {largest:.1}"), vec![Curve::new("lag", lag)]),
        Panel::curves("velocity [m/min]", vec![Curve::new("command", velocity)]),
    ];
    let over = Over { across: Across::Time { until: seconds(UNTIL_NS) }, events: Vec::new(), panels };
    let setup = vec![format!("Simulated: Kv {KV}/s, {SETUP}")];
    Picture { title: title.to_owned(), setup, parts: vec![Part::Over(over)] }.svg()
}
