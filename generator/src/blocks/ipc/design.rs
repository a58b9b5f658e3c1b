//! Improved position control as it is designed, once: the bands, the sections with their places, the coefficients.

use crate::axis::{Axis, Filter, Stage};
use crate::design::band::{Band, band, edges, frequency, warped};
use crate::design::{allpass, bandpass, oscillation};
use portable::RealKind;
use reference::ipc::{Coeffs, STAGES};
use reference::stage::FILTERS;
use reference::{filter, stage};
use std::fmt;

/// Improved position control of one axis.
#[derive(Clone, Debug)]
pub struct Design {
    /// the stages; an inactive one is `None`
    pub stage: [Option<StageDesign>; STAGES],
    /// the coefficients, in double precision; single precision rounds each of them once
    pub coeffs: Coeffs<f64>,
}

/// An active stage.
#[derive(Clone, Debug)]
pub struct StageDesign {
    /// where its filters lie; none: no filter
    pub passband: [Option<Passband>; FILTERS],
    /// all its sections, in the order of their execution
    pub section: Vec<Section>,
}

/// Where a filter lies.
#[derive(Clone, Copy, Debug)]
pub struct Passband {
    /// on the warped frequency axis
    pub band: Band,
    /// lower and upper edge [Hz]: -3 dB of a band-pass, -90 and -270 degrees of an all-pass
    pub edges: [f64; 2],
}

/// A second-order section as designed.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// where it is
    pub element: Element,
    /// centre on the warped frequency axis: tan(pi f Ts)
    pub g: f64,
    /// reciprocal of its quality factor
    pub k: f64,
    /// gain at its own centre
    pub c: f64,
    /// denominator: y = ... - a1 y(one cycle ago)
    pub a1: f64,
    /// denominator: y = ... - a2 y(two cycles ago)
    pub a2: f64,
}

/// Where a section is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// the simulated oscillation of a stage
    Oscillation {
        /// index of the stage
        stage: usize,
    },
    /// a section of a band-pass
    Bandpass {
        /// index of the stage
        stage: usize,
        /// index of the filter
        filter: usize,
        /// index of the section
        section: usize,
    },
    /// an all-pass
    Allpass {
        /// index of the stage
        stage: usize,
        /// index of the filter
        filter: usize,
    },
}

/// Among the coefficients: `stage[0].filter[1].bandpass[2]`.
impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Oscillation { stage } => write!(f, "stage[{stage}].oscillation"),
            Self::Bandpass { stage, filter, section } => {
                write!(f, "stage[{stage}].filter[{filter}].bandpass[{section}]")
            }
            Self::Allpass { stage, filter } => write!(f, "stage[{stage}].filter[{filter}].allpass"),
        }
    }
}

impl Element {
    /// The stage that it is part of.
    pub(crate) fn stage(self) -> usize {
        match self {
            Self::Oscillation { stage } | Self::Bandpass { stage, .. } | Self::Allpass { stage, .. } => stage,
        }
    }

    /// The filter that it is part of.
    pub(crate) fn filter(self) -> Option<usize> {
        match self {
            Self::Oscillation { .. } => None,
            Self::Bandpass { filter, .. } | Self::Allpass { filter, .. } => Some(filter),
        }
    }

    /// Among the state: `stage[0].filter[1].section[2]`.
    pub(crate) fn in_state(self) -> String {
        match self {
            Self::Oscillation { .. } => self.to_string(),
            Self::Bandpass { stage, filter, section } => format!("stage[{stage}].filter[{filter}].section[{section}]"),
            Self::Allpass { stage, filter } => format!("stage[{stage}].filter[{filter}].section[0]"),
        }
    }
}

/// Designs improved position control of an axis. All mathematics is done in f64 with `libm`, so that every host finds the same
/// bits.
///
/// - limit = v_add_max_fact / 1000 * v_max (P-AXIS-00757, P-AXIS-00212), in the unit of v_max: um/s or 0.001 deg/s.
/// - rest = v_max * 2^-60 in double, v_max * 2^-40 in single precision: far below one increment, far above what a
///   section at rest decays to.
/// - fade: [`fade_cycles`].
#[must_use]
pub fn design(axis: &Axis) -> Design {
    let ipc = &axis.ipc;
    let (limit, fade_cycles) = (ipc.limit(), fade_cycles(axis));
    let mut coeffs = Coeffs {
        cycle_time_ns: axis.cycle_time_ns,
        enable: ipc.enable as i32,
        slave: axis.control.master.is_some(),
        stage: Default::default(),
        limit,
        lower_limit: 0.0 - limit, // not `-limit`: 0 stays +0
        rest: ipc.v_max * rest_fraction(axis.real),
        fade_cycles,
        fade_step: 1.0 / f64::from(fade_cycles),
    };
    let stage = std::array::from_fn(|i| {
        let (design, of_stage) = stage_of(i, ipc.stage[i].as_ref()?, axis.cycle_time());
        coeffs.stage[i] = of_stage;
        Some(design)
    });
    Design { stage, coeffs }
}

/// The part of v_max below which a sum counts as 0: 2^-60 in double, 2^-40 in single precision.
fn rest_fraction(real: RealKind) -> f64 {
    match real {
        RealKind::F64 => libm::ldexp(1.0, -60),
        RealKind::F32 => libm::ldexp(1.0, -40),
    }
}

/// Cycles of the whole fade: ceil(fade time / Ts), at least 1.
///
/// A decimal fraction such as 0.1 s / 0.001 s is rarely exact in binary. A quotient within 1e-9 of a whole number
/// (relative) counts as that number, so that neither 100.00000000000001 becomes 101 nor a fade grows by a cycle when it
/// is written in another unit; a fade is thereby at most a part in 1e9 shorter than asked for.
///
/// # Panics
/// If there are more than 2^24 cycles, which the check excludes: beyond, f32 cannot count.
#[must_use]
pub fn fade_cycles(axis: &Axis) -> u32 {
    let quotient = axis.ipc.fade_time() * 1e9 / f64::from(axis.cycle_time_ns);
    let nearest = libm::round(quotient);
    let cycles = if (quotient - nearest).abs() <= 1e-9 * quotient { nearest } else { libm::ceil(quotient) };
    let most = crate::axis::Ipc::MAX_FADE_CYCLES;
    assert!(cycles <= most, "design: the check lets no fade of {cycles} cycles through");
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number, 1 to 2^24")]
    {
        cycles.max(1.0) as u32
    }
}

/// A stage at the cycle time [s].
///
/// gain = -weight = -min(num / denom, 7): negative in all modes, because the stage moves the motor against the vibration
/// (P-AXIS-00753, P-AXIS-00754, P-AXIS-00755). The simulated oscillation has the centre of the stage's first band-pass.
#[must_use]
pub fn stage_of(index: usize, of: &Stage, cycle_time: f64) -> (StageDesign, stage::Coeffs<f64>) {
    let mut coeffs = stage::Coeffs { gain: -of.weight(), ..stage::Coeffs::default() };
    (coeffs.mode, coeffs.direct_source) = source(of.mode);
    let mut section = Vec::with_capacity(1 + FILTERS * filter::MAX_ORDER);
    if let Some(damping) = of.mode.osc_damping() {
        let g = warped(of.f0(), cycle_time);
        coeffs.oscillation = oscillation::coefficients(g, damping);
        let (a1, a2) = (coeffs.oscillation.a1, coeffs.oscillation.a2);
        section.push(Section { element: Element::Oscillation { stage: index }, g, k: 2.0 * damping, c: 1.0, a1, a2 });
    }
    let mut passband = [None; FILTERS];
    for (k, filter) in of.filter.iter().enumerate() {
        coeffs.filter[k] = filter_of([index, k], filter, cycle_time, &mut section);
        passband[k] = passband_of(filter, cycle_time);
    }
    (StageDesign { passband, section }, coeffs)
}

/// Coefficients of a filter (P-AXIS-00849) at the cycle time [s]; what its type does not use is 0. Its sections are added to
/// those of its stage.
pub fn filter_of(
    [stage, filter]: [usize; 2],
    of: &Filter,
    cycle_time: f64,
    sections: &mut Vec<Section>,
) -> filter::Coeffs<f64> {
    let mut coeffs = filter::Coeffs::default();
    match *of {
        Filter::NoFilter => {}
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            coeffs.kind = filter::Type::Bandpass;
            coeffs.order = order;
            let designed = bandpass::sections(prototype, order, &band(f0, q_factor, cycle_time));
            for (section, (place, of)) in coeffs.bandpass.iter_mut().zip(&designed).enumerate() {
                *place = bandpass::coefficients(of);
                let element = Element::Bandpass { stage, filter, section };
                sections.push(Section { element, g: of.g, k: of.k, c: of.c, a1: place.a1, a2: place.a2 });
            }
        }
        Filter::Allpass { f0, q_factor } => {
            let band = band(f0, q_factor, cycle_time);
            coeffs.kind = filter::Type::Allpass;
            coeffs.allpass = allpass::coefficients(&band);
            let (a1, a2) = (coeffs.allpass.a1, coeffs.allpass.a2);
            let (g, k) = (band.omega0, band.bandwidth / band.omega0);
            sections.push(Section { element: Element::Allpass { stage, filter }, g, k, c: 1.0, a1, a2 });
        }
    }
    coeffs
}

fn passband_of(filter: &Filter, cycle_time: f64) -> Option<Passband> {
    match *filter {
        Filter::NoFilter => None,
        Filter::Bandpass { f0, q_factor, .. } | Filter::Allpass { f0, q_factor } => {
            let band = band(f0, q_factor, cycle_time);
            Some(Passband { band, edges: edges(&band).map(|t| frequency(t, cycle_time)) })
        }
    }
}

fn source(mode: crate::axis::Mode) -> (stage::Mode, stage::DirectSource) {
    use crate::axis::{DirectSource, Mode};
    match mode {
        Mode::Direct { source: DirectSource::Motor } => (stage::Mode::Direct, stage::DirectSource::Motor),
        Mode::Direct { source: DirectSource::Direct } => (stage::Mode::Direct, stage::DirectSource::Direct),
        Mode::Indirect { .. } => (stage::Mode::Indirect, stage::DirectSource::default()),
        Mode::SetPoint { .. } => (stage::Mode::SetPoint, stage::DirectSource::default()),
    }
}
