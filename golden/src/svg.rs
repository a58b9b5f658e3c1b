//! Panels over one time axis as SVG: curves, and rows that are filled while something holds. Nothing of what they mean is here.
//!
//! No font and no colour scheme is embedded; greys of middle lightness read on white and on dark. What is one of two is solid, the
//! other one dashed: a picture reads without colours. Coordinates have one decimal.

use portable::Extreme;
use std::fmt::Write;

/// Time [s] and value.
pub type Point = (f64, f64);

/// What is drawn.
#[derive(Clone, Debug)]
pub struct Picture {
    /// first line above
    pub title: String,
    /// second line above
    pub setup: String,
    /// right end of the time axis [s]
    pub until: f64,
    /// what begins when [s]: lines through all panels, with names above
    pub events: Vec<(f64, String)>,
    pub panels: Vec<Panel>,
}

/// A part of the picture.
#[derive(Clone, Debug)]
pub enum Panel {
    Curves(Curves),
    Rows(Rows),
}

/// Curves on one scale.
#[derive(Clone, Debug)]
pub struct Curves {
    /// what they are, with the unit
    pub name: String,
    /// lowest and highest value, and the step between lines; none: as the curves need it
    pub scale: Option<[f64; 3]>,
    /// values with a name, as lines across
    pub marks: Vec<(f64, String)>,
    pub curves: Vec<Curve>,
}

/// One curve; the second one of a panel is dashed.
#[derive(Clone, Debug)]
pub struct Curve {
    pub name: String,
    /// pieces, between which the curve jumps
    pub pieces: Vec<Vec<Point>>,
}

/// Rows, each with the times in which it is filled.
#[derive(Clone, Debug)]
pub struct Rows {
    pub rows: Vec<(String, Vec<[f64; 2]>)>,
}

/// What every picture begins with.
pub const HEAD: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 "#;

const WIDTH: f64 = 760.0;
const MARGIN: f64 = 16.0;
const LEFT: f64 = 126.0;
const RIGHT: f64 = 690.0;
/// Where the first panel begins.
const TOP: f64 = 92.0;
/// Heights of a panel with curves, of its name, of a row, and between panels.
const CURVES: f64 = 150.0;
const NAME: f64 = 24.0;
const ROW: f64 = 18.0;
const GAP: f64 = 16.0;
/// Height of a line of text, and width of a letter, about.
const LETTERS: f64 = 12.0;
const LETTER: f64 = 7.6;
/// Below the last panel.
const FOOT: f64 = 44.0;

/// Points on a line of the file.
const POINTS: usize = 8;
/// Lines of a scale, at most.
const STEPS: f64 = 6.0;
/// Numbers at the time axis, at most.
const TIMES: f64 = 10.0;

const INK: &str = "#767676";
/// Of the curves of a panel: colour and dashes.
const LINES: [(&str, &str); 2] = [("#2f81d8", ""), ("#c0661a", r#" stroke-dasharray="5 3""#)];

/// Where values of a panel are.
struct Scale {
    until: f64,
    /// value and place of the upper and the lower edge
    high: (f64, f64),
    low: (f64, f64),
}

impl Scale {
    fn y(&self, value: f64) -> f64 {
        let part = (value - self.low.0) / (self.high.0 - self.low.0);
        self.low.1 - part * (self.low.1 - self.high.1)
    }
}

/// The file.
#[must_use]
pub fn svg(picture: &Picture) -> String {
    let mut lines = Vec::new();
    let mut y = TOP;
    for panel in &picture.panels {
        y = match panel {
            Panel::Curves(panel) => curves(panel, picture.until, y, &mut lines),
            Panel::Rows(panel) => rows(panel, picture.until, y, &mut lines),
        } + GAP;
    }
    let bottom = y - GAP;
    times(picture, bottom, &mut lines);
    let height = bottom + FOOT;
    let mut all = vec![
        format!(
            r#"{HEAD}{WIDTH} {height}" width="{WIDTH}" height="{height}" role="img" font-family="sans-serif" font-size="12">"#
        ),
        format!("<title>{}</title>", escaped(&picture.title)),
        format!(
            r#"<text x="{MARGIN:.1}" y="26.0" font-size="15" font-weight="bold" fill="{INK}">{}</text>"#,
            escaped(&picture.title)
        ),
        text([MARGIN, 48.0], "start", INK, &picture.setup),
    ];
    all.append(&mut lines);
    all.push("</svg>".to_owned());
    all.join("\n") + "\n"
}

/// A panel with curves; gives its lower edge.
fn curves(panel: &Curves, until: f64, top: f64, lines: &mut Vec<String>) -> f64 {
    let (top, bottom) = (top + NAME, top + NAME + CURVES);
    let [low, high, step] = panel.scale.unwrap_or_else(|| scale(panel));
    let scale = Scale { until, high: (high, top), low: (low, bottom) };
    lines.push(text([MARGIN, top - 10.0], "start", INK, &panel.name));
    legend(panel, top - 10.0, lines);
    let values = (0..).map(|n| low + f64::from(n) * step).take_while(|value| *value < high + step / 2.0);
    for value in values {
        let y = scale.y(value);
        lines.push(line([LEFT, y, RIGHT, y], if value == 0.0 { "1" } else { "0.3" }, ""));
        lines.push(text([LEFT - 8.0, y + 4.0], "end", INK, &number(value, step)));
    }
    let mut named: Vec<f64> = Vec::new();
    for (value, name) in panel.marks.iter().filter(|(value, _)| (low..=high).contains(value)) {
        let y = scale.y(*value);
        lines.push(line([LEFT, y, RIGHT, y], "0.8", r#" stroke-dasharray="1 3""#));
        if named.iter().all(|other| (other - y).abs() >= LETTERS) {
            lines.push(text([RIGHT + 6.0, y + 4.0], "start", INK, name));
            named.push(y);
        }
    }
    for (curve, (colour, dashes)) in panel.curves.iter().zip(LINES) {
        for piece in &curve.pieces {
            lines.push(format!(
                r#"<polyline fill="none" stroke="{colour}" stroke-width="1.6" stroke-linejoin="round"{dashes} points=""#
            ));
            lines.push(points(piece, &scale));
            lines.push(r#""/>"#.to_owned());
        }
    }
    bottom
}

/// The names of the curves, each behind a piece of its line, at the right end.
fn legend(panel: &Curves, y: f64, lines: &mut Vec<String>) {
    let mut x = RIGHT;
    for (curve, (colour, dashes)) in panel.curves.iter().zip(LINES).rev() {
        lines.push(text([x, y], "end", colour, &curve.name));
        x -= LETTER * curve.name.len() as f64 + 8.0;
        lines.push(format!(
            r#"<line x1="{:.1}" y1="{:.1}" x2="{x:.1}" y2="{:.1}" stroke="{colour}" stroke-width="1.6"{dashes}/>"#,
            x - 26.0,
            y - 4.0,
            y - 4.0
        ));
        x -= 44.0;
    }
}

/// A panel with rows; gives its lower edge.
fn rows(panel: &Rows, until: f64, top: f64, lines: &mut Vec<String>) -> f64 {
    let mut y = top;
    for (name, times) in &panel.rows {
        lines.push(text([LEFT - 8.0, y + ROW - 5.0], "end", INK, name));
        lines.push(line([LEFT, y + ROW, RIGHT, y + ROW], "0.3", ""));
        for [from, to] in times {
            let [from, to] = [from, to].map(|time| LEFT + time / until * (RIGHT - LEFT));
            // What is short must be seen.
            let width = (to - from).larger(1.0);
            lines.push(format!(
                r#"<rect x="{from:.1}" y="{:.1}" width="{width:.1}" height="{:.1}" fill="{INK}"/>"#,
                y + 3.0,
                ROW - 5.0
            ));
        }
        y += ROW;
    }
    y
}

/// The time axis below the last panel, and the events through all of them.
fn times(picture: &Picture, bottom: f64, lines: &mut Vec<String>) {
    let step = step(picture.until, TIMES);
    for n in (0..).take_while(|n| f64::from(*n) * step <= picture.until) {
        let time = f64::from(n) * step;
        let x = LEFT + time / picture.until * (RIGHT - LEFT);
        lines.push(line([x, TOP, x, bottom], "0.2", ""));
        lines.push(text([x, bottom + 18.0], "middle", INK, &number(time, step)));
    }
    lines.push(text([(LEFT + RIGHT) / 2.0, bottom + 36.0], "middle", INK, "time [s]"));
    // Names that would lie on each other stand behind each other.
    let mut names: Vec<(f64, String)> = Vec::new();
    for (time, name) in &picture.events {
        let x = LEFT + time / picture.until * (RIGHT - LEFT);
        lines.push(line([x, TOP - 16.0, x, bottom], "0.8", ""));
        match names.last_mut().filter(|(first, names)| x - first < LETTER * (names.len() as f64 + 1.0)) {
            Some((_, names)) => *names += &format!(" {name}"),
            None => names.push((x, name.clone())),
        }
    }
    lines.extend(names.iter().map(|(x, name)| text([x + 3.0, TOP - 8.0], "start", INK, name)));
}

fn line(ends: [f64; 4], opacity: &str, dashes: &str) -> String {
    let [x1, y1, x2, y2] = ends;
    format!(
        r#"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" stroke="{INK}" stroke-opacity="{opacity}"{dashes}/>"#
    )
}

fn text(at: [f64; 2], anchor: &str, colour: &str, text: &str) -> String {
    let [x, y] = at;
    format!(r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{colour}">{}</text>"#, escaped(text))
}

/// Coordinates of points, some on each line of the file.
fn points(points: &[Point], scale: &Scale) -> String {
    let mut text = String::new();
    for (k, (time, value)) in points.iter().enumerate() {
        let separator = if k == 0 {
            ""
        } else if k % POINTS == 0 {
            "\n"
        } else {
            " "
        };
        let x = LEFT + time / scale.until * (RIGHT - LEFT);
        write!(text, "{separator}{x:.1},{:.1}", scale.y(*value)).expect("svg: a string takes all text");
    }
    text
}

/// Lowest and highest line, and the step, as the values of a panel need it; 0 is among them.
fn scale(panel: &Curves) -> [f64; 3] {
    let values = panel.curves.iter().flat_map(|curve| curve.pieces.iter().flatten()).map(|point| point.1);
    let (low, high) =
        values.fold((0.0, 0.0), |(low, high), value| (f64::smaller(low, value), f64::larger(high, value)));
    let step = step(f64::larger(high - low, f64::MIN_POSITIVE), STEPS);
    let (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
    if high > low { [low, high, step] } else { [0.0, 1.0, 1.0] }
}

/// The smallest of 0.001, 0.002, 0.005, 0.01, ... that divides a range into at most so many.
fn step(range: f64, most: f64) -> f64 {
    let steps = (-3..=12).flat_map(|power| [1.0, 2.0, 5.0].map(|factor| factor * 10.0_f64.powi(power)));
    steps.into_iter().find(|step| step * most >= range).unwrap_or(range)
}

/// A number at a scale: with decimals, where the step has some.
fn number(value: f64, step: f64) -> String {
    let decimals = if step >= 1.0 {
        0
    } else if step >= 0.1 {
        1
    } else if step >= 0.01 {
        2
    } else {
        3
    };
    let text = format!("{:.decimals$}", value.abs());
    let is_zero = text.bytes().all(|byte| matches!(byte, b'0' | b'.'));
    if value < 0.0 && !is_zero { format!("\u{2212}{text}") } else { text }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
