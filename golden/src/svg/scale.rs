//! The place of a value in a picture, and the lines of a scale.

use portable::Extreme;

/// Maximum number of lines of a scale.
const STEPS: f64 = 6.0;

/// A linear scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    /// value and place of both ends
    pub low: (f64, f64),
    pub high: (f64, f64),
}

impl Scale {
    pub(super) fn place(&self, value: f64) -> f64 {
        let part = (value - self.low.0) / (self.high.0 - self.low.0);
        self.low.1 + part * (self.high.1 - self.low.1)
    }

    pub(super) fn holds(&self, value: f64) -> bool {
        (self.low.0..=self.high.0).contains(&value)
    }
}

/// Lowest and highest line, and the step, for some values and 0.
pub(super) fn around(values: impl Iterator<Item = f64>) -> [f64; 3] {
    let (low, high) = values.fold((0.0_f64, 0.0_f64), |(low, high), value| (low.smaller(value), high.larger(value)));
    if high <= low {
        return [0.0, 1.0, 1.0];
    }
    let step = step(high - low, STEPS);
    [(low / step).floor() * step, (high / step).ceil() * step, step]
}

/// The smallest of 0.001, 0.002, 0.005, 0.01, ... that divides a range into at most `most` parts.
pub(super) fn step(range: f64, most: f64) -> f64 {
    let steps = (-3..=12).flat_map(|power| [1.0, 2.0, 5.0].map(|factor| factor * 10.0_f64.powi(power)));
    steps.into_iter().find(|step| step * most >= range).unwrap_or(range)
}

/// The lines of a scale from its lowest to its highest one.
pub(super) fn lines([low, high, step]: [f64; 3]) -> impl Iterator<Item = f64> {
    (0..).map(move |n| low + f64::from(n) * step).take_while(move |value| *value < high + step / 2.0)
}

/// The lines of a logarithmic scale: 1 to 9 of each power of ten, and whether a line has a label.
pub(super) fn decades(from: f64, to: f64) -> impl Iterator<Item = (f64, bool)> {
    let all = (-3..=6).flat_map(|power| (1..=9).map(move |digit| (f64::from(digit) * 10.0_f64.powi(power), digit)));
    all.filter(move |(value, _)| (from..=to).contains(value)).map(|(value, digit)| (value, [1, 2, 5].contains(&digit)))
}

/// The label of a scale: with decimals if the step has some.
pub(super) fn number(value: f64, step: f64) -> String {
    let decimals = [1.0, 0.1, 0.01].iter().take_while(|least| step < **least).count();
    let text = format!("{:.decimals$}", value.abs());
    let is_zero = text.bytes().all(|byte| matches!(byte, b'0' | b'.'));
    if value < 0.0 && !is_zero { format!("\u{2212}{text}") } else { text }
}
