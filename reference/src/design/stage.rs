//! All numbers of a stage.

#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use super::band::{Band, band};
use super::inputs::Inputs;
use super::poles::Prototype;
use super::sections::{self, Shape, Shapes};
use super::{allpass, bandpass, limit, oscillation};
use crate::filter::{self, MAX_ORDER, Type};
use crate::stage::{Coeffs, FILTERS, Numbers, is_centre_of_oscillation};
use portable::{Real, portable};

/// Designs the numbers of a stage from inputs in their ranges, at the cycle time [s].
///
/// The structure is the mode, the types and the orders of `structure`, and the prototypes; its numbers are not used. The
/// simulated oscillation has the centre of the first band-pass. Numbers that the structure does not have stay as they are.
#[portable]
pub fn design<R: Real>(
    numbers: &mut Numbers<R>,
    structure: &Coeffs<R>,
    prototypes: &[Prototype; FILTERS],
    inputs: &Inputs<R>,
    cycle_time: R,
) {
    for k in 0..FILTERS {
        if structure.filter[k].kind != Type::NoFilter {
            let mut of = Band::<R>::default();
            band(&mut of, inputs.filter[k].f0, inputs.filter[k].q_factor, cycle_time);
            filter_sections(&mut numbers.filter[k], &structure.filter[k], prototypes[k], &of);
            if is_centre_of_oscillation(structure, k) {
                let mut shape = Shape::<R>::default();
                oscillation::section(&mut shape, of.omega0, inputs.damping);
                sections::oscillation_numbers(&mut numbers.oscillation, &shape);
            }
        }
    }
    numbers.gain = limit::gain(inputs.weight);
}

/// Designs the sections of a filter from its band.
#[portable]
pub fn filter_sections<R: Real>(
    numbers: &mut filter::Numbers<R>,
    structure: &filter::Coeffs<R>,
    prototype: Prototype,
    of: &Band<R>,
) {
    let mut designed = Shapes::<R>::default();
    shapes(&mut designed, structure, prototype, of);
    match structure.kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            for i in 0..MAX_ORDER {
                if i < structure.order {
                    sections::bandpass_numbers(&mut numbers.bandpass[i], &designed.section[i]);
                }
            }
        }
        Type::Allpass => sections::allpass_numbers(&mut numbers.allpass, &designed.section[0]),
    }
}

/// The sections of a filter before the transform, in the order of their execution.
#[portable]
pub fn shapes<R: Real>(designed: &mut Shapes<R>, structure: &filter::Coeffs<R>, prototype: Prototype, of: &Band<R>) {
    match structure.kind {
        Type::NoFilter => {}
        Type::Bandpass => bandpass::sections(designed, prototype, structure.order, of),
        Type::Allpass => allpass::section(&mut designed.section[0], of),
    }
}
