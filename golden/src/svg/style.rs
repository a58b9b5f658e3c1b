//! The elements of a drawing: colours and dashes, lines, texts, curves.

use std::fmt::Write;

/// The colour of texts and scales.
pub(super) const INK: &str = "#767676";

/// The curves of a panel, four at most, in their order: colour and dashes. They can be distinguished with two colours only,
/// and without colours by their dashes.
pub const STYLES: [(&str, &str); 4] = [
    ("#2f81d8", ""),
    ("#c0661a", r#" stroke-dasharray="5 3""#),
    ("#0c8563", r#" stroke-dasharray="2 2""#),
    ("#a8458f", r#" stroke-dasharray="9 3 2 3""#),
];

/// A place in the picture.
type Place = (f64, f64);

/// Points on a line of the file.
const POINTS: usize = 8;
/// Approximate width of a letter.
pub(super) const LETTER: f64 = 7.2;
/// Height of a line of text.
pub(super) const LETTERS: f64 = 12.0;
/// Length of the sample line before a name.
const PIECE: f64 = 26.0;
const BETWEEN: f64 = 18.0;
/// Points that are closer to each other than this are drawn as one.
const NEAR: f64 = 0.8;

/// Horizontal and vertical lines: opacity, and further attributes.
pub(super) fn line(ends: [f64; 4], opacity: &str, dashes: &str) -> String {
    let [x1, y1, x2, y2] = ends;
    format!(
        r#"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" stroke="{INK}" stroke-opacity="{opacity}"{dashes}/>"#
    )
}

pub(super) fn text(at: [f64; 2], anchor: &str, colour: &str, text: &str) -> String {
    let [x, y] = at;
    format!(r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{colour}">{}</text>"#, escaped(text))
}

/// The names of curves, each after a sample of its line, at the right end.
pub(super) fn legend<'n>(
    names: impl DoubleEndedIterator<Item = &'n str> + ExactSizeIterator,
    right: f64,
    y: f64,
    lines: &mut Vec<String>,
) {
    let mut x = right;
    for (name, (colour, dashes)) in names.zip(STYLES).rev() {
        lines.push(text([x, y], "end", colour, name));
        x -= LETTER * name.len() as f64 + 8.0;
        lines.push(format!(
            r#"<line x1="{:.1}" y1="{:.1}" x2="{x:.1}" y2="{:.1}" stroke="{colour}" stroke-width="1.6"{dashes}/>"#,
            x - PIECE,
            y - 4.0,
            y - 4.0
        ));
        x -= PIECE + BETWEEN;
    }
}

/// A piece of a curve, of places.
pub(super) fn polyline(places: impl Iterator<Item = Place>, style: usize, lines: &mut Vec<String>) {
    let (colour, dashes) = STYLES[style % STYLES.len()];
    lines.push(format!(
        r#"<polyline fill="none" stroke="{colour}" stroke-width="1.6" stroke-linejoin="round"{dashes} points=""#
    ));
    lines.push(points(places));
    lines.push(r#""/>"#.to_owned());
}

/// Contents clipped to a frame, from left and top to right and bottom.
pub(super) fn framed(
    [left, top, right, bottom]: [f64; 4],
    lines: &mut Vec<String>,
    draw: impl FnOnce(&mut Vec<String>),
) {
    let (width, height) = (right - left, bottom - top);
    lines.push(format!(
        r#"<svg x="{left:.1}" y="{top:.1}" width="{width:.1}" height="{height:.1}" viewBox="{left:.1} {top:.1} {width:.1} {height:.1}">"#
    ));
    draw(lines);
    lines.push("</svg>".to_owned());
}

/// Coordinates of points, some on each line of the file. Of several points closer than `NEAR` the first one is drawn.
fn points(points: impl Iterator<Item = Place>) -> String {
    let mut kept: Vec<Place> = Vec::new();
    let mut points = points.peekable();
    while let Some((x, y)) = points.next() {
        let is_near = |(other_x, other_y): &Place| (other_x - x).abs() < NEAR && (other_y - y).abs() < NEAR;
        if points.peek().is_none() || !kept.last().is_some_and(is_near) {
            kept.push((x, y));
        }
    }
    let mut text = String::new();
    for (k, (x, y)) in kept.iter().enumerate() {
        let separator = match k {
            0 => "",
            k if k % POINTS == 0 => "\n",
            _ => " ",
        };
        write!(text, "{separator}{x:.1},{y:.1}").expect("svg: a string takes all text");
    }
    text
}

pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
