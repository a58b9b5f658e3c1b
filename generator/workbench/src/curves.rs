//! The loop of an axis as numbers, for pictures with a cursor: four digits after the point, which is less than a pixel.

use generator::analysis::{self, OfDrive, headline};
use generator::blocks::Designed;
use golden::analysis::picture;
use golden::svg::Part;
use serde::Serialize;

/// The loop of an axis with each drive, by frequency.
#[derive(Clone, Debug, Serialize)]
pub struct Curves {
    pub hz: Vec<f64>,
    /// gain [dB] and phase [deg] of each stage with its weight
    pub stages: Vec<StageCurve>,
    pub drives: Vec<DriveCurve>,
    /// the f0 of the stages [Hz]
    pub f0: Vec<f64>,
    /// the Nyquist curves as a picture
    pub nyquist: String,
}

#[derive(Clone, Debug, Serialize)]
pub struct StageCurve {
    pub stage: usize,
    pub gain: Vec<f64>,
    pub phase: Vec<f64>,
}

/// L, S = 1/(1 + L) and T = L/(1 + L) with a drive.
#[derive(Clone, Debug, Serialize)]
pub struct DriveCurve {
    pub drive: String,
    /// its margins in words
    pub headline: String,
    pub gain: Vec<f64>,
    pub phase: Vec<f64>,
    pub sensitivity: Vec<f64>,
    pub closed: Vec<f64>,
}

/// The curves; `None` if no stage closes a loop.
pub fn curves(designed: &Designed) -> Option<Curves> {
    let analysis = analysis::analyze(designed, &designed.axis.drive);
    let first = analysis.drives.first()?;
    let stage = |stage: usize| StageCurve {
        stage,
        gain: first.curve.iter().map(|at| decibels(at.stage[stage].norm_sqr())).collect(),
        phase: first.curve.iter().map(|at| degrees(at.stage[stage].im, at.stage[stage].re)).collect(),
    };
    // The other parts are drawn with a cursor.
    let mut plane = picture(designed, &analysis)?;
    plane.parts.retain(|part| matches!(part, Part::Plane(_)));
    plane.setup.clear();
    let f0 = designed.axis.ipc.stage.iter().flatten().map(generator::axis::Stage::f0).collect();
    Some(Curves {
        hz: first.curve.iter().map(|at| at.hz).collect(),
        stages: first.stages.iter().map(|of| stage(of.stage)).collect(),
        drives: analysis.drives.iter().map(|of| drive(of, first)).collect(),
        f0,
        nyquist: plane.svg(),
    })
}

/// The points of a drive at the frequencies of the first one.
fn drive(of: &OfDrive, first: &OfDrive) -> DriveCurve {
    let mut from = of.curve.iter().peekable();
    let mut points = Vec::with_capacity(first.curve.len());
    for at in &first.curve {
        while from.peek().is_some_and(|next| next.hz < at.hz) {
            from.next();
        }
        points.push(from.peek().or(of.curve.last().as_ref()).map_or(at.open, |point| point.open));
    }
    let over: Vec<f64> = points.iter().map(|open| (1.0 + open).norm_sqr()).collect();
    DriveCurve {
        drive: of.drive.short().to_owned(),
        headline: headline(of),
        gain: points.iter().map(|open| decibels(open.norm_sqr())).collect(),
        phase: points.iter().map(|open| degrees(open.im, open.re)).collect(),
        sensitivity: over.iter().map(|square| decibels(1.0 / square)).collect(),
        closed: points.iter().zip(&over).map(|(open, square)| decibels(open.norm_sqr() / square)).collect(),
    }
}

fn decibels(square: f64) -> f64 {
    rounded(10.0 * libm::log10(square))
}

fn degrees(im: f64, re: f64) -> f64 {
    rounded(libm::atan2(im, re).to_degrees())
}

fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}
