//! A designed stage: its bands, its sections with their places, its coefficients. No limit, no fade.

use super::filter::{self as kinds, FilterDesign};
use crate::axis::{DirectSource, Mode, Stage};
use crate::design::band::{band, edges, frequency};
use crate::design::rounding::in_precision;
use crate::design::trapezoidal::{Output, Trapezoidal};
use portable::RealKind;
use reference::design::inputs::{FilterInputs, Inputs};
use reference::design::limit::norm;
use reference::design::poles::Prototype;
use reference::design::sections::{Shape, Shapes};
use reference::design::{oscillation, stage as portable_design};
use reference::{filter, stage, stage::FILTERS};
use std::fmt;

/// An active stage.
#[derive(Clone, Debug)]
pub struct StageDesign {
    pub index: usize,
    /// its parameters
    pub stage: Stage,
    /// cycle time [s]
    pub cycle_time: f64,
    pub filter: [Option<FilterDesign>; FILTERS],
    /// all its sections, in the order of their execution
    pub section: Vec<Section>,
    pub coeffs: stage::Coeffs<f64>,
    /// what its numbers are designed from
    pub inputs: Inputs<f64>,
    pub prototypes: [Prototype; FILTERS],
    /// largest output for velocities within +-1
    pub norm: f64,
}

/// A second-order section.
#[derive(Clone, Debug)]
pub struct Section {
    pub element: Element,
    pub shape: Shape<f64>,
    /// denominator 1 + a1 z^-1 + a2 z^-2 of the biquad, for double precision
    pub denominator: [f64; 2],
    /// the section for single precision, its coefficients rounded
    pub trapezoidal: Trapezoidal,
    /// the section for single precision before the rounding
    pub unrounded: Trapezoidal,
}

/// The place of a section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    pub stage: usize,
    /// `None` for the simulated oscillation
    pub filter: Option<Place>,
}

/// The place of a section within a filter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
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
    pub fn in_state(&self) -> String {
        let Some(Place { filter, section, .. }) = &self.filter else { return self.to_string() };
        format!("stage[{}].filter[{filter}].section[{section}]", self.stage)
    }
}

/// A stage at the cycle time [s]: structure and inputs from its parameters, numbers from [`portable_design`].
pub fn stage(index: usize, of: &Stage, cycle_time: f64) -> StageDesign {
    let (mode, direct_source) = match of.mode {
        Mode::Direct { source: DirectSource::Motor } => (stage::Mode::Direct, stage::DirectSource::Motor),
        Mode::Direct { source: DirectSource::Direct } => (stage::Mode::Direct, stage::DirectSource::Direct),
        Mode::Indirect { .. } => (stage::Mode::Indirect, stage::DirectSource::default()),
        Mode::SetPoint { .. } => (stage::Mode::SetPoint, stage::DirectSource::default()),
    };
    let mut structure = stage::Coeffs { mode, direct_source, ..stage::Coeffs::default() };
    let damping = of.mode.osc_damping();
    let mut inputs = Inputs { damping: damping.unwrap_or_default(), weight: of.weight(), ..Inputs::default() };
    let mut prototypes = [Prototype::default(); FILTERS];
    for (k, filter) in of.filter.iter().enumerate() {
        if let (Some([f0, q_factor]), Some(kind)) = (filter.f0_and_q(), kinds::of(filter)) {
            inputs.filter[k] = FilterInputs { f0, q_factor };
            prototypes[k] = kind.decide(&mut structure.filter[k]);
        }
    }
    let mut numbers = stage::Numbers::default();
    portable_design::design(&mut numbers, &structure, &prototypes, &inputs, cycle_time);
    let mut design = StageDesign {
        index,
        stage: of.clone(),
        cycle_time,
        filter: [None; FILTERS],
        section: Vec::with_capacity(1 + FILTERS * filter::MAX_ORDER),
        coeffs: with(structure, &numbers),
        inputs,
        prototypes,
        norm: norm(&structure, &inputs),
    };
    design.section.extend(damping.map(|damping| simulated_oscillation(index, damping, &numbers.oscillation)));
    for (k, prototype) in prototypes.into_iter().enumerate() {
        design.describe_filter(k, prototype);
    }
    design
}

/// The structure with its numbers. `with_numbers` does the same for any type, scalar by scalar: that took 1 % of a check.
fn with(structure: stage::Coeffs<f64>, numbers: &stage::Numbers<f64>) -> stage::Coeffs<f64> {
    let stage::Numbers { oscillation, filter, gain } = *numbers;
    let mut coeffs = stage::Coeffs { oscillation, gain, ..structure };
    for (coeffs, filter::Numbers { bandpass, allpass }) in coeffs.filter.iter_mut().zip(filter) {
        (coeffs.bandpass, coeffs.allpass) = (bandpass, allpass);
    }
    coeffs
}

fn simulated_oscillation(stage: usize, damping: f64, of: &reference::oscillation::Coeffs<f64>) -> Section {
    let mut shape = Shape::default();
    oscillation::section(&mut shape, of.g, damping);
    let section =
        |[h, r, g, c]: [f64; 4]| Trapezoidal { a: g * h, b: g * r, c, output: Output::Oscillation, is_by_change: true };
    let numbers = [of.h, of.r, of.g, of.g2];
    Section {
        element: Element { stage, filter: None },
        shape,
        denominator: [of.a1, of.a2],
        trapezoidal: section(numbers.map(single)),
        unrounded: section(numbers),
    }
}

impl StageDesign {
    /// Describes a filter and its sections (P-AXIS-00849).
    fn describe_filter(&mut self, index: usize, prototype: Prototype) {
        let filter = self.stage.filter[index];
        let (Some([f0, q_factor]), Some(kind)) = (filter.f0_and_q(), kinds::of(&filter)) else { return };
        let band = band(f0, q_factor, self.cycle_time);
        let edges = edges(&band).map(|t| frequency(t, self.cycle_time));
        self.filter[index] = Some(FilterDesign { index, filter, band, edges });
        let coeffs = &self.coeffs.filter[index];
        let follows_bandpass = self.stage.filter[..index].iter().any(kinds::is_selective) && kind.is_selective();
        let mut shapes = Shapes::default();
        portable_design::shapes(&mut shapes, coeffs, prototype, &band);
        for (i, shape) in shapes.section.into_iter().enumerate().take(kind.order()) {
            let numbers = kind.numbers(coeffs, i);
            let is_by_change = i == 0 && !follows_bandpass;
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
