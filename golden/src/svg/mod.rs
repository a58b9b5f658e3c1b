//! Pictures as numbers and as SVG: panels over one axis of time or frequency, and a plane for Nyquist curves. Their meaning is
//! not known here.
//!
//! No font is embedded, and no background: pictures are readable on white and on dark. Each curve of a panel has its own
//! dashes, so that a picture is readable without colours. Coordinates have one decimal.

mod across;
mod curves;
mod plane;
mod rows;
mod scale;
mod style;

pub use style::STYLES;

use serde::Serialize;
use style::{INK, escaped, text};

/// A position on the axis below, and the value.
pub type Point = (f64, f64);

/// The contents of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct Picture {
    /// first line above
    pub title: String,
    /// further lines above
    pub setup: Vec<String>,
    /// from top to bottom
    pub parts: Vec<Part>,
}

/// A part of a picture with its own axes.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    Over(Over),
    Plane(Plane),
}

/// Panels over one axis.
#[derive(Clone, Debug, Serialize)]
pub struct Over {
    pub across: Across,
    /// events with their times or frequencies: lines through these panels, with names above
    pub events: Vec<(f64, String)>,
    pub panels: Vec<Panel>,
}

/// The axis of panels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Across {
    /// from 0 to this time [s]
    Time { until: f64 },
    /// between two frequencies [Hz], logarithmic
    Frequency { from: f64, to: f64 },
}

/// A panel over an axis.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Panel {
    Curves(Curves),
    Rows(Rows),
}

/// Curves on one scale.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Curves {
    /// their quantity and unit
    pub name: String,
    /// lowest and highest value, and the step between lines; `None` to fit the curves
    pub scale: Option<[f64; 3]>,
    /// named values, drawn as horizontal lines
    pub marks: Vec<(f64, String)>,
    pub curves: Vec<Curve>,
}

#[derive(Clone, Debug, Serialize)]
pub struct Curve {
    pub name: String,
    /// continuous pieces of the curve
    pub pieces: Vec<Vec<Point>>,
}

/// Rows, each with the times in which it is filled.
#[derive(Clone, Debug, Serialize)]
pub struct Rows {
    pub rows: Vec<(String, Vec<[f64; 2]>)>,
}

/// Curves in a plane with equal scales on both axes.
#[derive(Clone, Debug, Serialize)]
pub struct Plane {
    /// its contents
    pub name: String,
    /// left and right end; the height follows, with 0 in the middle
    pub across: [f64; 2],
    /// centre, radius and name
    pub circles: Vec<(Point, f64, String)>,
    /// marked points with a name
    pub marks: Vec<(Point, String)>,
    pub curves: Vec<Curve>,
}

/// The beginning of every picture.
pub const HEAD: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 "#;

const WIDTH: f64 = 760.0;
const MARGIN: f64 = 16.0;
const LEFT: f64 = 126.0;
const RIGHT: f64 = 690.0;
/// Place of the first line of the setup, and from one to the next.
const SETUP: f64 = 48.0;
const LINE: f64 = 18.0;
/// Above the first panel of a part: names of events; height of the name above a panel, and between panels.
const EVENTS: f64 = 20.0;
const NAME: f64 = 24.0;
const GAP: f64 = 16.0;
/// Below the last panel of a part: the numbers and the name of its axis.
const FOOT: f64 = 44.0;

impl Panel {
    /// Curves on a scale that fits them.
    #[must_use]
    pub fn curves(name: impl Into<String>, curves: Vec<Curve>) -> Self {
        Self::Curves(Curves { name: name.into(), curves, ..Curves::default() })
    }
}

impl Curve {
    /// A curve in one piece.
    #[must_use]
    pub fn new(name: impl Into<String>, points: Vec<Point>) -> Self {
        Self { name: name.into(), pieces: vec![points] }
    }

    /// A curve that is interrupted where it jumps by more than `jump`.
    #[must_use]
    pub fn broken(name: impl Into<String>, points: impl Iterator<Item = Point>, jump: f64) -> Self {
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        for point in points {
            let jumps = |last: &Point| (last.1 - point.1).abs() > jump;
            match pieces.last_mut().filter(|piece| !piece.last().is_some_and(jumps)) {
                Some(piece) => piece.push(point),
                None => pieces.push(vec![point]),
            }
        }
        Self { name: name.into(), pieces }
    }
}

impl Picture {
    /// The file.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut lines = Vec::new();
        let setup = self.setup.iter().zip(0_u32..);
        lines.extend(setup.map(|(line, n)| text([MARGIN, SETUP + LINE * f64::from(n)], "start", INK, line)));
        let mut height = SETUP + LINE * (self.setup.len() as f64 - 1.0) + GAP;
        for part in &self.parts {
            height = GAP
                + match part {
                    Part::Over(over) => over.draw(height, &mut lines),
                    Part::Plane(plane) => plane.draw(height, &mut lines),
                };
        }
        let mut all = vec![
            format!(
                r#"{HEAD}{WIDTH} {height}" width="{WIDTH}" height="{height}" role="img" font-family="sans-serif" font-size="12">"#
            ),
            format!("<title>{}</title>", escaped(&self.title)),
            format!(
                r#"<text x="{MARGIN:.1}" y="26.0" font-size="15" font-weight="bold" fill="{INK}">{}</text>"#,
                escaped(&self.title)
            ),
        ];
        all.append(&mut lines);
        all.push("</svg>".to_owned());
        all.join("\n") + "\n"
    }
}

impl Over {
    /// Draws the panels below a place; returns the lower end of the axis.
    fn draw(&self, top: f64, lines: &mut Vec<String>) -> f64 {
        let top = if self.events.is_empty() { top } else { top + EVENTS };
        let mut y = top;
        for panel in &self.panels {
            y = GAP
                + match panel {
                    Panel::Curves(panel) => panel.draw(self.across, y, lines),
                    Panel::Rows(panel) => panel.draw(self.across, y, lines),
                };
        }
        self.across.draw(&self.events, [top, y - GAP], lines);
        y - GAP + FOOT
    }
}
