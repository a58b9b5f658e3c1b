//! A certificate in words: short lines of ASCII for the head of a file and for the terminal. Nothing is computed.

use super::{Certificate, Point, noise};
use crate::blocks::Figure;
use crate::design::response::{Complex, angle, magnitude};
use crate::design::rounding::{at_least, precision, sample_limit};
use crate::number::digits;
use portable::Extreme;

/// The lines: the range, the response of each stage at each of its band-passes, the largest deviation.
pub fn lines(certificate: &Certificate) -> Vec<String> {
    let mut lines = vec![range(certificate)];
    let shown = certificate.response.iter().filter(|band| band.is_shown);
    lines.extend(shown.map(|band| response(band.stage, &band.points)));
    lines.push(certificate.deviation().map_or_else(
        || "response: not measured, a limit of 0 mutes the block (P-AXIS-00757)".to_owned(),
        |deviation| format!("largest deviation of measured from designed: {deviation:.1e}"),
    ));
    if !certificate.noise.is_empty() {
        lines.push(noise::text(&certificate.noise, certificate.v_max, certificate.unit));
    }
    lines
}

/// The proven bound of the sum before the limit; `None` if the block adds nothing, or if no bound is proven.
pub fn figure(certificate: &Certificate) -> Option<Figure> {
    let Certificate { real, unit, v_max, limit, bound, .. } = certificate;
    let value = bound.v_sum * v_max;
    let doc = format!("guaranteed bound of |v_add| before the limit, for |v| <= {} [{unit}]", digits(*v_max));
    (*limit > 0.0 && value.is_finite()).then(|| Figure { name: "BOUND", doc, value: at_least(value, *real) })
}

fn range(certificate: &Certificate) -> String {
    let Certificate { real, unit, v_max, limit, bound, .. } = certificate;
    if !bound.state.is_finite() || !bound.v_sum.is_finite() {
        return "range: no guaranteed bound, because a section is so weakly damped that its rounding errors can accumulate".to_owned();
    }
    let (muted, v_add) = if *limit > 0.0 {
        ("", format!("|v_add| <= {} before the limit and ", digits(bound.v_sum * v_max)))
    } else {
        ("the limit is 0, v_add is always 0; ", String::new())
    };
    let sample_limit = sample_limit(*real);
    format!(
        "range: {muted}|v| <= {} {unit} gives {v_add}no |state| above {}; for |v| <= {}: {}, {} {} precision",
        digits(*v_max),
        digits(bound.state * v_max),
        digits(sample_limit),
        digits(bound.state.larger(bound.v_sum) * sample_limit),
        if certificate.is_within_precision() { "within" } else { "NOT within" },
        precision(*real)
    )
}

fn response(stage: usize, points: &[Point]) -> String {
    let points = points.iter().map(|Point { frequency, designed, measured, .. }| {
        format!("at {} Hz: designed {}, measured {}", digits(*frequency), polar(*designed), polar(*measured))
    });
    format!("stage[{stage}] {}", points.collect::<Vec<_>>().join("; "))
}

/// Gain and phase, the latter above -179.9999999 and up to 180 degrees.
fn polar(h: Complex) -> String {
    let angle = angle(h);
    let angle = if angle.abs() < 5e-8 { 0.0 } else { angle }; // only rounding
    format!("{} at {} deg", digits(magnitude(h)), digits(angle))
}
