//! A panel with rows, each filled while a condition holds.

use super::style::{INK, line, text};
use super::{Across, LEFT, RIGHT, Rows};

/// Height of a row.
const ROW: f64 = 18.0;

impl Rows {
    /// Draws the panel below a place; returns its lower edge.
    pub(super) fn draw(&self, across: Across, top: f64, lines: &mut Vec<String>) -> f64 {
        let mut y = top;
        for (name, times) in &self.rows {
            lines.push(text([LEFT - 8.0, y + ROW - 5.0], "end", INK, name));
            lines.push(line([LEFT, y + ROW, RIGHT, y + ROW], "0.3", ""));
            for [from, to] in times {
                let [from, to] = [from, to].map(|time| across.place(*time));
                // Short times must be visible.
                let width = if to - from < 1.0 { 1.0 } else { to - from };
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
}
