//! The picture of an analysis: Bode diagrams of the stages and of the open loop, |S|, and the Nyquist curve near -1. Drawing
//! is in `svg`, the analysis in the generator.

use crate::svg::{Across, Curve, Curves, Over, Panel, Part, Picture, Plane, Point};
use generator::analysis::{Analysis, OfDrive, headline};
use generator::blocks::Designed;
use portable::Extreme;
use stability::{Complex64, MAX_MS};

/// The picture begins at this part of the lowest f0.
const LOWEST: f64 = 1.0 / 20.0;
/// Scales: magnitude and |S| [dB], phase [degrees].
const MAGNITUDE: [f64; 3] = [-40.0, 20.0, 10.0];
const SENSITIVITY: [f64; 3] = [-30.0, 15.0, 5.0];
const PHASE: [f64; 3] = [-180.0, 180.0, 90.0];
/// Visible range of the plane of L, from left to right.
const PLANE: [f64; 2] = [-3.0, 1.5];
/// A larger change of the phase between two points means that it has passed 180 degrees.
const JUMP: f64 = 180.0;

/// The picture of an axis; `None` if no stage closes a loop.
#[must_use]
pub fn picture(designed: &Designed, analysis: &Analysis) -> Option<Picture> {
    let first = analysis.drives.first()?;
    let nyquist = 0.5 / designed.axis.cycle_time();
    let stages: Vec<(usize, f64)> = stages(designed).collect();
    let from = stages.iter().map(|(_, f0)| *f0).fold(nyquist, f64::smaller) * LOWEST;
    let bode = bode(first);
    let of_drives = |value: fn(f64, Complex64) -> Point| -> Vec<Curve> {
        let points = |of: &OfDrive| of.curve.iter().map(|at| value(at.hz, at.open)).collect();
        analysis.drives.iter().map(|of| Curve::new(of.drive.short(), points(of))).collect()
    };
    let shown = |curves: Vec<Curve>| curves.into_iter().map(|curve| within(curve, from, nyquist)).collect();
    let panel = |name: &str, scale, curves, marks: &[(f64, &str)]| {
        let marks = marks.iter().map(|(value, name)| (*value, (*name).to_owned())).collect();
        Panel::Curves(Curves { name: name.to_owned(), scale: Some(scale), marks, curves: shown(curves) })
    };
    let sensitivity = of_drives(|hz, open| (hz, decibels(1.0 / (1.0 + open))));
    let over = Over {
        across: Across::Frequency { from, to: nyquist },
        events: f0_events(&stages),
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
    Some(Picture {
        title: format!("axis {}: the loop of improved position control", designed.axis.name),
        setup: analysis.drives.iter().map(headline).collect(),
        parts: vec![Part::Over(over), Part::Plane(plane)],
    })
}

/// Both Bode diagrams: of each stage from `v_motor` to `v_add`, and of L.
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
        Curve::new(name, values.iter().map(|(hz, value)| (*hz, decibels(*value))).collect())
    };
    let phase = |(name, values): &(String, Vec<(f64, Complex64)>)| {
        let degrees = |value: &Complex64| libm::atan2(value.im, value.re).to_degrees();
        Curve::broken(name, values.iter().map(|(hz, value)| (*hz, degrees(value))), JUMP)
    };
    Bode { magnitude: all.iter().map(magnitude).collect(), phase: all.iter().map(phase).collect() }
}

fn decibels(value: Complex64) -> f64 {
    10.0 * libm::log10(value.norm_sqr())
}

/// The part of a curve between two frequencies.
fn within(mut curve: Curve, from: f64, to: f64) -> Curve {
    for piece in &mut curve.pieces {
        piece.retain(|(hz, value)| (from..=to).contains(hz) && value.is_finite());
    }
    curve.pieces.retain(|piece| !piece.is_empty());
    curve
}

/// The active stages of an axis with their f0 [Hz].
pub(crate) fn stages(designed: &Designed) -> impl Iterator<Item = (usize, f64)> {
    let all = designed.axis.ipc.stage.iter().enumerate();
    all.filter_map(|(index, stage)| Some((index, stage.as_ref()?.f0())))
}

/// The f0 of stages, as events over frequency.
pub(crate) fn f0_events(stages: &[(usize, f64)]) -> Vec<(f64, String)> {
    let mut events: Vec<(f64, String)> =
        stages.iter().map(|(index, f0)| (*f0, format!("f0 of stage {index}"))).collect();
    events.sort_by(|a, b| a.0.total_cmp(&b.0));
    events
}
