//! What must not run on a machine although each parameter is in its range: sections that rounding has spoilt.

use super::band::{band, frequency, warped};
use super::denominator::at_dc_and_nyquist;
use super::{allpass, bandpass, filter, oscillation, stage};
use crate::axis::{Axis, Filter};
use portable::{Real, RealKind};

/// Why a parameter set would endanger the machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// the section or filter as the coefficients name it, such as `stage[0].filter[1].bandpass[2]`
    pub path: String,
    /// what is wrong
    pub found: String,
    /// what would be allowed
    pub allowed: String,
    /// what to write instead
    pub instead: String,
}

/// The largest relative difference between a section's centre frequency as designed and as its rounded coefficients
/// realise it. At a section's quality factor of 20 it turns the phase by 2 degrees.
pub const MAX_CENTRE_ERROR: f64 = 1e-3;

/// The lowest f0 Ts of a filter. Measured against extended precision with a third-order Butterworth band-pass, Q 10, a
/// vibration of 1 on a velocity of 500: double keeps 98 dB at 1e-6 (125 dB at 6e-6, 73 dB at 3e-7), single 80 dB at 0.01
/// (39 dB at 7e-4). Below, what a biquad adds is more and more its own rounding.
#[must_use]
pub fn lowest(real: RealKind) -> f64 {
    match real {
        RealKind::F64 => 1e-6,
        RealKind::F32 => 0.01,
    }
}

/// Refuses what the coefficients, rounded to the axis's real type, would do wrong: a filter below [`lowest`]; a section
/// that is unstable, |a2| >= 1 or |a1| >= 1 + a2; one whose centre is off by more than [`MAX_CENTRE_ERROR`].
#[must_use]
pub fn unusable(axis: &Axis) -> Vec<Refusal> {
    let sections = match axis.real {
        RealKind::F64 => sections::<f64>(axis),
        RealKind::F32 => sections::<f32>(axis),
    };
    let spoilt = sections.iter().filter_map(|section| spoilt(section, axis));
    too_low(axis).into_iter().chain(spoilt).collect()
}

/// A section as designed and as rounded.
struct Section {
    path: String,
    /// designed centre on the warped frequency axis
    g: f64,
    a1: f64,
    a2: f64,
}

fn sections<R: Real>(axis: &Axis) -> Vec<Section> {
    let cycle_time = axis.cycle_time();
    let mut sections = Vec::new();
    for (i, stage) in axis.ipc.stage.iter().enumerate() {
        let Some(stage) = stage else { continue };
        if let Some(damping) = stage::osc_damping(stage.mode) {
            let g = warped(stage.f0(), cycle_time);
            let coeffs = oscillation::coefficients::<R>(g, damping);
            let path = format!("stage[{i}].oscillation");
            sections.push(Section { path, g, a1: coeffs.a1.to_f64(), a2: coeffs.a2.to_f64() });
        }
        for (k, filter) in stage.filter.iter().enumerate() {
            match *filter {
                Filter::NoFilter => {}
                Filter::Bandpass { prototype, order, f0, q_factor } => {
                    let designed = bandpass::sections(prototype, order, &band(f0, q_factor, cycle_time));
                    for (j, section) in designed.iter().enumerate() {
                        let coeffs = bandpass::coefficients::<R>(section);
                        let path = format!("stage[{i}].filter[{k}].bandpass[{j}]");
                        sections.push(Section { path, g: section.g, a1: coeffs.a1.to_f64(), a2: coeffs.a2.to_f64() });
                    }
                }
                Filter::Allpass { f0, q_factor } => {
                    let band = band(f0, q_factor, cycle_time);
                    let coeffs = allpass::coefficients::<R>(&band);
                    let path = format!("stage[{i}].filter[{k}].allpass");
                    sections.push(Section { path, g: band.omega0, a1: coeffs.a1.to_f64(), a2: coeffs.a2.to_f64() });
                }
            }
        }
    }
    sections
}

fn spoilt(section: &Section, axis: &Axis) -> Option<Refusal> {
    let Section { path, g, a1, a2 } = section;
    let precision = precision(axis.real);
    let [dc, nyquist] = at_dc_and_nyquist(1.0, *a1, *a2);
    if !(*a2 < 1.0 && dc > 0.0 && nyquist > 0.0) {
        return Some(Refusal {
            path: path.clone(),
            found: format!("unstable with its coefficients in {precision} precision: a1 = {a1:e}, a2 = {a2:e}"),
            allowed: "|a2| < 1 and |a1| < 1 + a2".to_owned(),
            instead: instead_of(path, axis.real),
        });
    }
    let designed = frequency(*g, axis.cycle_time());
    let realised = frequency(libm::sqrt(dc / nyquist), axis.cycle_time());
    ((realised - designed).abs() > MAX_CENTRE_ERROR * designed).then(|| Refusal {
        path: path.clone(),
        found: format!(
            "centre frequency {designed:.4e} Hz is {realised:.4e} Hz with its coefficients in {precision} precision"
        ),
        allowed: format!("a difference of {} %", MAX_CENTRE_ERROR * 100.0),
        instead: instead_of(path, axis.real),
    })
}

fn too_low(axis: &Axis) -> Vec<Refusal> {
    let mut refusals = Vec::new();
    for (i, stage) in axis.ipc.stage.iter().enumerate() {
        for (k, filter) in stage.iter().flat_map(|stage| stage.filter.iter().enumerate()) {
            let Some(f0) = filter::f0(filter) else { continue };
            // From nanoseconds: 160 Hz and 62.5 us make exactly 0.01.
            let cycles = f0 * f64::from(axis.cycle_time_ns) / 1e9;
            if cycles < lowest(axis.real) {
                refusals.push(Refusal {
                    path: format!("stage[{i}].filter[{k}]"),
                    found: format!(
                        "f0 = {f0} Hz (P-AXIS-00751) drowns in the rounding of {} precision: f0 * Ts = {cycles:.4e}",
                        precision(axis.real)
                    ),
                    allowed: format!("f0 * Ts >= {}", lowest(axis.real)),
                    instead: instead(axis.real),
                });
            }
        }
    }
    refusals
}

fn precision(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "double",
        RealKind::F32 => "single",
    }
}

/// The simulated oscillation is at the mercy of its damping, a filter of its frequency.
fn instead_of(path: &str, real: RealKind) -> String {
    if path.ends_with("oscillation") {
        format!("a larger osc_damping (P-AXIS-00850), {}", instead(real))
    } else {
        instead(real)
    }
}

fn instead(real: RealKind) -> String {
    match real {
        RealKind::F64 => "a higher fg_f0 (P-AXIS-00751) or a longer cycle time".to_owned(),
        RealKind::F32 => "double precision, a higher fg_f0 (P-AXIS-00751) or a longer cycle time".to_owned(),
    }
}
