//! A panel with curves.

use super::scale::{Scale, around, lines as lines_of, number};
use super::style::{INK, LETTERS, framed, legend, line, polyline, text};
use super::{Across, Curves, LEFT, MARGIN, NAME, RIGHT};

/// Height of a panel.
const HEIGHT: f64 = 150.0;

impl Curves {
    /// Draws the panel below a place; returns its lower edge.
    pub(super) fn draw(&self, across: Across, top: f64, lines: &mut Vec<String>) -> f64 {
        let (top, bottom) = (top + NAME, top + NAME + HEIGHT);
        let [low, high, step] = self.scale.unwrap_or_else(|| around(self.values()));
        let scale = Scale { low: (low, bottom), high: (high, top) };
        lines.push(text([MARGIN, top - 10.0], "start", INK, &self.name));
        legend(self.curves.iter().map(|curve| curve.name.as_str()), RIGHT, top - 10.0, lines);
        for value in lines_of([low, high, step]) {
            let y = scale.place(value);
            lines.push(line([LEFT, y, RIGHT, y], if value == 0.0 { "1" } else { "0.3" }, ""));
            lines.push(text([LEFT - 8.0, y + 4.0], "end", INK, &number(value, step)));
        }
        self.draw_marks(&scale, lines);
        if self.values().all(|value| scale.holds(value)) {
            self.draw_curves(across, &scale, lines);
        } else {
            framed([LEFT, top, RIGHT, bottom], lines, |lines| self.draw_curves(across, &scale, lines));
        }
        bottom
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.curves.iter().flat_map(|curve| curve.pieces.iter().flatten()).map(|point| point.1)
    }

    fn draw_marks(&self, scale: &Scale, lines: &mut Vec<String>) {
        let mut named: Vec<f64> = Vec::new();
        for (value, name) in self.marks.iter().filter(|(value, _)| scale.holds(*value)) {
            let y = scale.place(*value);
            lines.push(line([LEFT, y, RIGHT, y], "0.8", r#" stroke-dasharray="1 3""#));
            if named.iter().all(|other| (other - y).abs() >= LETTERS) {
                lines.push(text([RIGHT + 6.0, y + 4.0], "start", INK, name));
                named.push(y);
            }
        }
    }

    fn draw_curves(&self, across: Across, scale: &Scale, lines: &mut Vec<String>) {
        for (style, curve) in self.curves.iter().enumerate() {
            for piece in &curve.pieces {
                polyline(piece.iter().map(|(at, value)| (across.place(*at), scale.place(*value))), style, lines);
            }
        }
    }
}
