//! The picture of an analysis: Bode diagrams of the stages and of the open loop, |S|, and the Nyquist curve near -1. How a picture is
//! drawn is in `svg`, what an analysis is in the generator.

use crate::svg::{Across, Curve, Curves, Over, Panel, Part, Picture, Plane, Point};
use generator::analysis::{Analysis, OfDrive, summary};
use generator::axis::Stage;
use generator::blocks::Designed;
use portable::Extreme;
use stability::{Complex64, MAX_MS};

/// The picture begins at that part of the lowest f0.
const LOWEST: f64 = 1.0 / 20.0;
/// Scales: magnitude and |S| [dB], phase [degrees].
const MAGNITUDE: [f64; 3] = [-40.0, 20.0, 10.0];
const SENSITIVITY: [f64; 3] = [-30.0, 15.0, 5.0];
const PHASE: [f64; 3] = [-180.0, 180.0, 90.0];
/// What is seen of the plane of L, from left to right.
const PLANE: [f64; 2] = [-3.0, 1.5];
/// A phase that changes by more between two points has passed 180 degrees.
const JUMP: f64 = 180.0;

/// The picture of an axis; none: no stage closes a loop.
#[must_use]
pub fn svg(designed: &Designed, analysis: &Analysis) -> Option<String> {
    let first = analysis.drives.first()?;
    let nyquist = 0.5 / designed.axis.cycle_time();
    let f0 = designed.axis.ipc.stage.iter().flatten().map(|stage| stage.f0());
    let from = f0.fold(nyquist, f64::smaller) * LOWEST;
    let bode = bode(first);
    let of_drives = |value: fn(f64, Complex64) -> Point| -> Vec<Curve> {
        let points = |of: &OfDrive| of.curve.iter().map(|at| value(at.hz, at.open)).collect();
        (analysis.drives.iter()).map(|of| Curve { name: of.drive.short(), pieces: vec![points(of)] }).collect()
    };
    let shown = |curves: Vec<Curve>| curves.into_iter().map(|curve| within(curve, from, nyquist)).collect();
    let panel = |name: &str, scale, curves, marks: &[(f64, &str)]| {
        let marks = marks.iter().map(|(value, name)| (*value, (*name).to_owned())).collect();
        Panel::Curves(Curves { name: name.to_owned(), scale: Some(scale), marks, curves: shown(curves) })
    };
    let sensitivity = of_drives(|hz, open| (hz, decibels(1.0 / (1.0 + open))));
    let over = Over {
        across: Across::Frequency { from, to: nyquist },
        events: f0_names(designed),
        panels: vec![
            panel(&format!("magnitude [dB], {}", first.drive.short()), MAGNITUDE, bode.magnitude, &[]),
            panel("phase [deg]", PHASE, bode.phase, &[]),
            panel("|S| [dB]", SENSITIVITY, sensitivity, &[(20.0 * libm::log10(MAX_MS), "Ms 2")]),
        ],
    };
    let plane = Plane {
        name: "Nyquist curve of L".to_owned(),
        across: PLANE,
        circles: vec![((-1.0, 0.0), 1.0 / MAX_MS, "Ms 2".to_owned())],
        marks: vec![((-1.0, 0.0), "-1".to_owned())],
        curves: of_drives(|_, open| (open.re, open.im)),
    };
    let picture = Picture {
        title: format!("axis {}: the loop of improved position control", designed.axis.name),
        setup: analysis.drives.iter().map(summary).collect(),
        parts: vec![Part::Over(over), Part::Plane(plane)],
    };
    Some(picture.svg())
}

/// Both diagrams of Bode: of each stage from `v_motor` to `v_add`, and of L.
struct Bode {
    magnitude: Vec<Curve>,
    phase: Vec<Curve>,
}

fn bode(of: &OfDrive) -> Bode {
    let stages = of.stages.iter().map(|stage| stage.stage);
    let named =
        stages.map(|index| (format!("stage {index}"), of.curve.iter().map(|at| (at.hz, at.stage[index])).collect()));
    let open = ("L".to_owned(), of.curve.iter().map(|at| (at.hz, at.open)).collect());
    let all: Vec<(String, Vec<(f64, Complex64)>)> = named.chain([open]).collect();
    let magnitude = |(name, values): &(String, Vec<(f64, Complex64)>)| {
        let points = values.iter().map(|(hz, value)| (*hz, decibels(*value))).collect();
        Curve { name: name.clone(), pieces: vec![points] }
    };
    let phase = |(name, values): &(String, Vec<(f64, Complex64)>)| Curve { name: name.clone(), pieces: phases(values) };
    Bode { magnitude: all.iter().map(magnitude).collect(), phase: all.iter().map(phase).collect() }
}

fn decibels(value: Complex64) -> f64 {
    10.0 * libm::log10(value.norm_sqr())
}

/// The phase [degrees], broken where it passes 180.
fn phases(values: &[(f64, Complex64)]) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    for (hz, value) in values {
        let phase = libm::atan2(value.im, value.re).to_degrees();
        let jumps = |last: &Point| (last.1 - phase).abs() > JUMP;
        match pieces.last_mut().filter(|piece| !piece.last().is_some_and(jumps)) {
            Some(piece) => piece.push((*hz, phase)),
            None => pieces.push(vec![(*hz, phase)]),
        }
    }
    pieces
}

/// The part of a curve between two frequencies.
fn within(mut curve: Curve, from: f64, to: f64) -> Curve {
    for piece in &mut curve.pieces {
        piece.retain(|(hz, value)| (from..=to).contains(hz) && value.is_finite());
    }
    curve.pieces.retain(|piece| !piece.is_empty());
    curve
}

fn f0_names(designed: &Designed) -> Vec<(f64, String)> {
    let stages = designed.axis.ipc.stage.iter().enumerate();
    let name = |(index, stage): (usize, &Option<Stage>)| Some((stage.as_ref()?.f0(), format!("f0 of stage {index}")));
    let mut names: Vec<(f64, String)> = stages.filter_map(name).collect();
    names.sort_by(|a, b| a.0.total_cmp(&b.0));
    names
}
