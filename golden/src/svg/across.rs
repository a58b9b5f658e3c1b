//! The axis below the panels, its lines, and the events through all of them.

use super::scale::{decades, number, step};
use super::style::{INK, LETTER, line, text};
use super::{Across, LEFT, RIGHT};

/// Maximum number of labels of a time axis.
const TIMES: f64 = 10.0;

impl Across {
    /// The place of a time or a frequency.
    pub(super) fn place(self, at: f64) -> f64 {
        let part = match self {
            Self::Time { until } => at / until,
            Self::Frequency { from, to } => libm::log(at / from) / libm::log(to / from),
        };
        LEFT + part * (RIGHT - LEFT)
    }

    /// Draws the axis for panels between two places.
    pub(super) fn draw(self, events: &[(f64, String)], [top, bottom]: [f64; 2], lines: &mut Vec<String>) {
        for (at, name) in self.lines() {
            let x = self.place(at);
            lines.push(line([x, top, x, bottom], "0.2", ""));
            lines.extend(name.map(|name| text([x, bottom + 18.0], "middle", INK, &name)));
        }
        let name = match self {
            Self::Time { .. } => "time [s]",
            Self::Frequency { .. } => "frequency [Hz]",
        };
        lines.push(text([(LEFT + RIGHT) / 2.0, bottom + 36.0], "middle", INK, name));
        // Names that would overlap are placed after each other.
        let mut names: Vec<(f64, String)> = Vec::new();
        for (at, name) in events {
            let x = self.place(*at);
            lines.push(line([x, top - 16.0, x, bottom], "0.8", ""));
            match names.last_mut().filter(|(first, names)| x - first < LETTER * (names.len() as f64 + 1.0)) {
                Some((_, names)) => *names += &format!(" {name}"),
                None => names.push((x, name.clone())),
            }
        }
        lines.extend(names.iter().map(|(x, name)| text([x + 3.0, top - 8.0], "start", INK, name)));
    }

    /// Its lines, some with a label.
    fn lines(self) -> Vec<(f64, Option<String>)> {
        match self {
            Self::Time { until } => {
                let step = step(until, TIMES);
                let times = (0..).map(|n| f64::from(n) * step).take_while(|time| *time <= until);
                times.map(|time| (time, Some(number(time, step)))).collect()
            }
            Self::Frequency { from, to } => {
                decades(from, to).map(|(value, is_named)| (value, is_named.then(|| number(value, value)))).collect()
            }
        }
    }
}
