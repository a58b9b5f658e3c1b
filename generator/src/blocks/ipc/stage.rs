//! A designed stage: its bands, its sections with their places, its coefficients. No limit, no fade.

use super::filter::{self as kinds, FilterDesign};
use crate::axis::{DirectSource, Mode, Stage};
use crate::design::band::{band, edges, frequency, warped};
use crate::design::rounding::in_precision;
use crate::design::trapezoidal::{Output, Trapezoidal};
use crate::design::{section, section::Shape};
use portable::RealKind;
use reference::{filter, stage, stage::FILTERS};
use std::fmt;

/// An active stage.
#[derive(Clone, Debug)]
pub(crate) struct StageDesign {
    pub index: usize,
    /// its parameters
    pub stage: Stage,
    /// cycle time [s]
    pub cycle_time: f64,
    pub filter: [Option<FilterDesign>; FILTERS],
    /// all its sections, in the order of their execution
    pub section: Vec<Section>,
    pub coeffs: stage::Coeffs<f64>,
}

/// A second-order section.
#[derive(Clone, Debug)]
pub(crate) struct Section {
    pub element: Element,
    pub shape: Shape,
    /// denominator 1 + a1 z^-1 + a2 z^-2 of the biquad, for double precision
    pub denominator: [f64; 2],
    /// the section for single precision, its coefficients rounded
    pub trapezoidal: Trapezoidal,
    /// the section for single precision before the rounding
    pub unrounded: Trapezoidal,
}

/// The place of a section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Element {
    pub stage: usize,
    /// `None` for the simulated oscillation
    pub filter: Option<Place>,
}

/// The place of a section within a filter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub filter: usize,
    /// in the order of their execution
    pub section: usize,
    /// path among the coefficients of the filter
    pub name: String,
}

/// Path among the coefficients: `stage[0].filter[1].bandpass[2]`.
impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stage = self.stage;
        match &self.filter {
            None => write!(f, "stage[{stage}].oscillation"),
            Some(Place { filter, name, .. }) => write!(f, "stage[{stage}].filter[{filter}].{name}"),
        }
    }
}

impl Element {
    /// Path in the state: `stage[0].filter[1].section[2]`.
    pub(crate) fn in_state(&self) -> String {
        let Some(Place { filter, section, .. }) = &self.filter else { return self.to_string() };
        format!("stage[{}].filter[{filter}].section[{section}]", self.stage)
    }
}

/// A stage at the cycle time [s].
///
/// gain = -weight = -min(num / denom, 7): negative in all modes, because the stage moves the motor against the vibration
/// (P-AXIS-00753, P-AXIS-00754, P-AXIS-00755). The simulated oscillation has the centre of the stage's first band-pass.
pub(crate) fn stage(index: usize, of: &Stage, cycle_time: f64) -> StageDesign {
    let (mode, direct_source) = match of.mode {
        Mode::Direct { source: DirectSource::Motor } => (stage::Mode::Direct, stage::DirectSource::Motor),
        Mode::Direct { source: DirectSource::Direct } => (stage::Mode::Direct, stage::DirectSource::Direct),
        Mode::Indirect { .. } => (stage::Mode::Indirect, stage::DirectSource::default()),
        Mode::SetPoint { .. } => (stage::Mode::SetPoint, stage::DirectSource::default()),
    };
    let mut design = StageDesign {
        index,
        stage: of.clone(),
        cycle_time,
        filter: [None; FILTERS],
        section: Vec::with_capacity(1 + FILTERS * filter::MAX_ORDER),
        coeffs: stage::Coeffs { mode, direct_source, gain: -of.weight(), ..stage::Coeffs::default() },
    };
    if let Some(damping) = of.mode.osc_damping() {
        let shape = Shape { g: warped(of.f0(), cycle_time), k: 2.0 * damping, c: 1.0 };
        let coeffs = section::oscillation(&shape);
        let element = Element { stage: index, filter: None };
        let numbers = [coeffs.h, coeffs.r, coeffs.g, coeffs.g2];
        let section = |[h, r, g, c]: [f64; 4]| Trapezoidal {
            a: g * h,
            b: g * r,
            c,
            output: Output::Oscillation,
            is_by_change: true,
        };
        let (unrounded, trapezoidal) = (section(numbers), section(numbers.map(single)));
        design.section.push(Section { element, shape, denominator: [coeffs.a1, coeffs.a2], trapezoidal, unrounded });
        design.coeffs.oscillation = coeffs;
    }
    for k in 0..FILTERS {
        design.design_filter(k);
    }
    design
}

impl StageDesign {
    /// Designs a filter (P-AXIS-00849). Coefficients that its type does not use stay 0.
    fn design_filter(&mut self, index: usize) {
        let filter = self.stage.filter[index];
        let (Some([f0, q_factor]), Some(kind)) = (filter.f0_and_q(), kinds::of(&filter)) else { return };
        let band = band(f0, q_factor, self.cycle_time);
        let edges = edges(&band).map(|t| frequency(t, self.cycle_time));
        self.filter[index] = Some(FilterDesign { index, filter, band, edges });
        let coeffs = &mut self.coeffs.filter[index];
        let is_behind = self.stage.filter[..index].iter().any(kinds::is_selective) && kind.is_selective();
        let shapes = kind.shapes(&band);
        for (i, (numbers, shape)) in kind.design(&shapes, coeffs).into_iter().zip(shapes).enumerate() {
            let is_by_change = i == 0 && !is_behind;
            let section = |[a, b, c]: [f64; 3]| Trapezoidal { a, b, c, output: kind.output(), is_by_change };
            self.section.push(Section {
                element: Element {
                    stage: self.index,
                    filter: Some(Place { filter: index, section: i, name: kind.place(i) }),
                },
                shape,
                denominator: numbers.denominator,
                trapezoidal: section(numbers.trapezoidal.map(single)),
                unrounded: section(numbers.trapezoidal),
            });
        }
    }
}

/// A coefficient rounded to single precision.
fn single(coefficient: f64) -> f64 {
    in_precision(coefficient, RealKind::F32)
}
