//! A panel with equal scales on both axes: Nyquist curves.

use super::scale::{Scale, lines as lines_of, number, step};
use super::style::{INK, framed, legend, line, polyline, text};
use super::{FOOT, LEFT, MARGIN, NAME, Plane, RIGHT};

/// Height of the panel.
const HEIGHT: f64 = 320.0;
/// Maximum number of lines of a scale.
const STEPS: f64 = 10.0;
/// Half a mark.
const MARK: f64 = 4.0;

impl Plane {
    /// Draws the panel below a place; returns the lower end of its axis.
    pub(super) fn draw(&self, top: f64, lines: &mut Vec<String>) -> f64 {
        let (top, bottom) = (top + NAME, top + NAME + HEIGHT);
        let [left, right] = self.across;
        let half = (right - left) / (RIGHT - LEFT) * HEIGHT / 2.0;
        let x = Scale { low: (left, LEFT), high: (right, RIGHT) };
        let y = Scale { low: (-half, bottom), high: (half, top) };
        let step = step(right - left, STEPS);
        lines.push(text([MARGIN, top - 10.0], "start", INK, &self.name));
        legend(self.curves.iter().map(|curve| curve.name.as_str()), RIGHT, top - 10.0, lines);
        let first = |least: f64| (least / step).ceil() * step;
        let opacity = |value: f64| if value.abs() < step / 2.0 { "1" } else { "0.3" };
        for value in lines_of([first(left), right - step / 2.0, step]) {
            let at = x.place(value);
            lines.push(line([at, top, at, bottom], opacity(value), ""));
            lines.push(text([at, bottom + 18.0], "middle", INK, &number(value, step)));
        }
        for value in lines_of([first(-half), half - step / 2.0, step]) {
            let at = y.place(value);
            lines.push(line([LEFT, at, RIGHT, at], opacity(value), ""));
            lines.push(text([LEFT - 8.0, at + 4.0], "end", INK, &number(value, step)));
        }
        framed([LEFT, top, RIGHT, bottom], lines, |lines| self.draw_inside(&x, &y, lines));
        bottom + FOOT
    }

    fn draw_inside(&self, x: &Scale, y: &Scale, lines: &mut Vec<String>) {
        let unit = x.place(1.0) - x.place(0.0);
        for ((real, imaginary), radius, name) in &self.circles {
            let [cx, cy, r] = [x.place(*real), y.place(*imaginary), radius * unit];
            lines.push(format!(
                r#"<circle cx="{cx:.1}" cy="{cy:.1}" r="{r:.1}" fill="none" stroke="{INK}" stroke-dasharray="1 3"/>"#
            ));
            lines.push(text([cx, cy - r - 4.0], "middle", INK, name));
        }
        for ((real, imaginary), name) in &self.marks {
            let [at_x, at_y] = [x.place(*real), y.place(*imaginary)];
            lines.push(line([at_x - MARK, at_y - MARK, at_x + MARK, at_y + MARK], "1", r#" stroke-width="1.6""#));
            lines.push(line([at_x - MARK, at_y + MARK, at_x + MARK, at_y - MARK], "1", r#" stroke-width="1.6""#));
            lines.push(text([at_x + 8.0, at_y + 14.0], "start", INK, name));
        }
        for (style, curve) in self.curves.iter().enumerate() {
            for piece in &curve.pieces {
                polyline(piece.iter().map(|(re, im)| (x.place(*re), y.place(*im))), style, lines);
            }
        }
    }
}
