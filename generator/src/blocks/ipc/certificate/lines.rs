//! A certificate in words: short lines of ASCII for the head of a file and for the terminal. Nothing is computed.

use super::{Certificate, Point, StageCertificate};
use crate::design::response::{Complex, magnitude, phase};
use crate::number::digits;
use portable::RealKind;

/// The lines: the range, the response of each stage at each of its band-passes, the largest deviation.
#[must_use]
pub fn lines(certificate: &Certificate) -> Vec<String> {
    let mut lines = vec![range(certificate)];
    lines.extend(certificate.stage.iter().flat_map(responses));
    lines.push(certificate.deviation().map_or_else(
        || "response: not measured, a limit of 0 mutes the block (P-AXIS-00757)".to_owned(),
        |deviation| format!("largest deviation of measured from designed: {deviation:.1e}"),
    ));
    lines
}

fn range(certificate: &Certificate) -> String {
    let Certificate { v_max, sample_limit, limit, bound, .. } = certificate;
    if !bound.state.is_finite() || !bound.v_sum.is_finite() {
        return "range: no bound is certain, a section is so weakly damped that its roundings may add up".to_owned();
    }
    let precision = match certificate.real {
        RealKind::F64 => "double",
        RealKind::F32 => "single",
    };
    let verdict = if certificate.is_within_precision() { "within" } else { "NOT within" };
    let [state, largest_state] = [v_max, sample_limit].map(|scale| digits(bound.state * scale));
    if *limit <= 0.0 {
        return format!(
            "range: the limit is 0, v_add is always 0; |v| <= {} gives no |state| above {state}; for |v| <= {}: \
             {largest_state}, {verdict} {precision} precision",
            digits(*v_max),
            digits(*sample_limit),
        );
    }
    format!(
        "range: |v| <= {} gives |v_add| <= {} before the limit and no |state| above {state}; for |v| <= {}: {}, \
         {verdict} {precision} precision",
        digits(*v_max),
        digits(bound.v_sum * v_max),
        digits(*sample_limit),
        digits(bound.state.max(bound.v_sum) * sample_limit),
    )
}

fn responses(stage: &StageCertificate) -> Vec<String> {
    let line = |points: &[Point]| {
        let points = points.iter().map(|point| {
            let Point { frequency, designed, measured } = point;
            format!("at {} Hz: designed {}, measured {}", digits(*frequency), polar(*designed), polar(*measured))
        });
        format!("stage[{}] {}", stage.index, points.collect::<Vec<_>>().join("; "))
    };
    stage.band.iter().map(|band| line(&band.point)).collect()
}

/// Gain and phase, the latter above -179.9999999 and up to 180 degrees.
fn polar(h: Complex) -> String {
    let angle = phase(h);
    let angle = if angle < -179.999_999_9 { angle + 360.0 } else { angle };
    let angle = if angle.abs() < 5e-8 { 0.0 } else { angle }; // nothing but rounding
    format!("{} at {} deg", digits(magnitude(h)), digits(angle))
}
