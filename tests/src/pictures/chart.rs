//! A curve over time as SVG. Nothing of what it means is here.
//!
//! The colours are of middle lightness on no background, which reads on white and on dark. Coordinates have one decimal.

use std::fmt::Write;

/// Time [s] and value.
pub type Point = (f64, f64);

/// What is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Chart<'a> {
    /// first line above
    pub title: &'a str,
    /// second line above
    pub setup: &'a str,
    /// right end of the time axis [s]
    pub until: f64,
    /// what the curve is, with its unit, and what is to be said of it
    pub y: &'a str,
    /// the curve
    pub curve: &'a [Point],
    /// the velocity faintly behind it, as a part of the largest
    pub profile: &'a [Point],
    /// how large the largest is
    pub profile_top: &'a str,
}

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 380.0;
/// Where the lines above begin.
const MARGIN: f64 = 16.0;
/// The frame of the curve.
const LEFT: f64 = 76.0;
const RIGHT: f64 = 690.0;
const TOP: f64 = 66.0;
const BOTTOM: f64 = 330.0;

/// How high the profile goes, as a part of the upper half.
const PROFILE_HEIGHT: f64 = 0.9;

/// Points on a line of the file.
const POINTS: usize = 8;

const TEXT: &str = "#767676";
const GRID: &str = "#8c8c8c";
const CURVE: &str = "#2f81d8";
const PROFILE: &str = "#d98a1e";

/// Where values are in the picture.
struct Scale {
    until: f64,
    low: f64,
    high: f64,
}

impl Scale {
    fn x(&self, time: f64) -> f64 {
        LEFT + time / self.until * (RIGHT - LEFT)
    }

    fn y(&self, value: f64) -> f64 {
        BOTTOM - (value - self.low) / (self.high - self.low) * (BOTTOM - TOP)
    }
}

/// The file.
#[must_use]
pub fn svg(chart: &Chart<'_>) -> String {
    let step = step(chart.curve);
    let high = steps_beyond(chart.curve.iter().map(|point| point.1), step);
    let low = -steps_beyond(chart.curve.iter().map(|point| -point.1), step);
    let scale = Scale { until: chart.until, low: f64::from(low) * step, high: f64::from(high) * step };
    let mut lines = head(chart);
    lines.push(area(chart.profile, &scale));
    for n in low..=high {
        let value = f64::from(n) * step;
        let y = scale.y(value);
        lines.push(grid([LEFT, y, RIGHT, y], n == 0));
        lines.push(text([LEFT - 8.0, y + 4.0], "end", TEXT, &number(value)));
    }
    for tenths in (0u32..).step_by(2).take_while(|tenths| f64::from(*tenths) / 10.0 <= chart.until) {
        let time = f64::from(tenths) / 10.0;
        let x = scale.x(time);
        lines.push(grid([x, TOP, x, BOTTOM], tenths == 0));
        lines.push(text([x, BOTTOM + 18.0], "middle", TEXT, &format!("{time:.1}")));
    }
    lines.push(text([RIGHT + 8.0, scale.y(0.0) + 4.0], "start", PROFILE, "0"));
    lines.push(text([RIGHT + 8.0, scale.y(scale.high * PROFILE_HEIGHT) + 4.0], "start", PROFILE, chart.profile_top));
    lines.push(text([RIGHT, HEIGHT - 12.0], "end", PROFILE, "velocity"));
    lines.push(text([MARGIN, HEIGHT - 12.0], "start", CURVE, chart.y));
    lines.push(text([(LEFT + RIGHT) / 2.0, HEIGHT - 12.0], "middle", TEXT, "time [s]"));
    lines
        .push(format!(r#"<polyline fill="none" stroke="{CURVE}" stroke-width="1.8" stroke-linejoin="round" points=""#));
    lines.push(points(chart.curve, &scale));
    lines.push(r#""/>"#.to_owned());
    lines.push("</svg>".to_owned());
    lines.join("\n") + "\n"
}

fn head(chart: &Chart<'_>) -> Vec<String> {
    vec![
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img" font-family="sans-serif" font-size="12">"#
        ),
        format!("<title>{}: {}</title>", chart.title, chart.y),
        format!(
            r#"<text x="{MARGIN:.1}" y="26.0" font-size="15" font-weight="bold" fill="{TEXT}">{}</text>"#,
            chart.title
        ),
        text([MARGIN, 48.0], "start", TEXT, chart.setup),
    ]
}

fn area(profile: &[Point], scale: &Scale) -> String {
    let raised: Vec<Point> = profile.iter().map(|(time, part)| (*time, part * PROFILE_HEIGHT * scale.high)).collect();
    let attributes = format!(r#"fill="{PROFILE}" fill-opacity="0.13" stroke="{PROFILE}" stroke-opacity="0.4""#);
    format!("<polygon {attributes} points=\"\n{}\n\"/>", points(&raised, scale))
}

fn grid(ends: [f64; 4], is_axis: bool) -> String {
    let [x1, y1, x2, y2] = ends;
    let opacity = if is_axis { "1" } else { "0.3" };
    format!(r#"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" stroke="{GRID}" stroke-opacity="{opacity}"/>"#)
}

fn text(at: [f64; 2], anchor: &str, colour: &str, text: &str) -> String {
    let [x, y] = at;
    format!(r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{colour}">{text}</text>"#)
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
        write!(text, "{separator}{:.1},{:.1}", scale.x(*time), scale.y(*value)).expect("a string takes all");
    }
    text
}

/// The smallest of 1, 2, 5, 10, ... that divides the range of the curve into at most six.
fn step(curve: &[Point]) -> f64 {
    let (low, high) =
        curve.iter().fold((0.0, 0.0), |(low, high), point| (f64::min(low, point.1), f64::max(high, point.1)));
    let mut step = 1.0;
    for factor in [2.0, 2.5, 2.0].into_iter().cycle() {
        if step * 6.0 >= high - low {
            break;
        }
        step *= factor;
    }
    step
}

/// How many steps the largest value needs, at least one above 0.
fn steps_beyond(values: impl Iterator<Item = f64>, step: f64) -> i32 {
    let largest = values.fold(0.0, f64::max);
    (0..).find(|n| f64::from(*n) * step >= largest).expect("the numbers go on")
}

/// A whole number.
fn number(value: f64) -> String {
    format!("{}{:.0}", if value < 0.0 { "−" } else { "" }, value.abs())
}
