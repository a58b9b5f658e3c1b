//! The elements of a block, one for each filter: the inputs of the element whose turn it is, and the place of its numbers.
#![expect(clippy::explicit_counter_loop, reason = "an index of the portable subset exists only while specialising")]

use super::coeffs::Coeffs;
use super::signals::Inputs;
use crate::design::bandpass::{self, Pair};
use crate::design::poles::{has_pair, real_poles, real_sigma};
use crate::filter::{MAX_ORDER, Type};
use crate::ipc::STAGES;
use crate::stage::{self, FILTERS, Mode};
use portable::{Real, copy, note, portable};

/// An element: its place, its inputs as they were read, and its structure.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Element<R> {
    /// number of its stage
    pub stage: u32,
    /// number of its filter in the stage
    pub filter: u32,
    /// centre frequency [Hz]
    pub f0: R,
    /// quality factor
    pub q_factor: R,
    /// damping ratio of the simulated oscillation
    pub damping: R,
    /// weight of the stage
    pub weight: R,
    /// its filter is an all-pass
    pub is_allpass: bool,
    /// its stage has a simulated oscillation
    pub is_simulated: bool,
    /// that oscillation has its centre
    pub has_oscillation: bool,
    /// it is the first element of its stage
    pub opens_stage: bool,
    /// it is the last element of its stage
    pub closes_stage: bool,
    /// it has a pair of poles
    pub has_pair: bool,
    /// number of sections of real poles
    pub real: u32,
    /// number of its last section, from 0
    pub final_section: u32,
    /// sigma of its real poles
    pub sigma: R,
    /// its pair of poles
    pub pair: Pair<R>,
}

/// Whether no filter comes after filter `k`.
#[portable]
pub fn is_last<R: Real>(structure: &stage::Coeffs<R>, k: usize) -> bool {
    let mut last = true;
    for after in 0..FILTERS {
        last = last && (after <= k || structure.filter[after].kind == Type::NoFilter);
    }
    last
}

/// Reads filter `k` of stage `i`.
#[portable]
pub fn read<R: Real>(of: &mut Element<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, i: usize, k: usize) {
    let prototype = coeffs.prototype[i].filter[k];
    copy!(of = inputs.stage[i].filter[k]: f0, q_factor);
    of.is_simulated = coeffs.set.ipc.stage[i].mode != Mode::Direct;
    of.has_oscillation = stage::is_centre_of_oscillation(&coeffs.set.ipc.stage[i], k);
    of.opens_stage = stage::is_first(&coeffs.set.ipc.stage[i], k);
    if stage::is_first(&coeffs.set.ipc.stage[i], k) {
        note("the numbers of a stage are read once: its norm and its gain must agree");
        of.weight = inputs.stage[i].weight;
        if coeffs.set.ipc.stage[i].mode != Mode::Direct {
            of.damping = inputs.stage[i].damping;
        }
    }
    of.closes_stage = is_last(&coeffs.set.ipc.stage[i], k);
    of.has_pair = false;
    of.real = 0u32;
    match coeffs.set.ipc.stage[i].filter[k].kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            let order = coeffs.set.ipc.stage[i].filter[k].order;
            of.is_allpass = false;
            of.final_section = count(order) - 1u32;
            of.real = count(real_poles(prototype, order));
            of.sigma = real_sigma(prototype, order);
            if has_pair(prototype, order) {
                of.has_pair = true;
                bandpass::poles(&mut of.pair, prototype, order);
            }
        }
        Type::Allpass => {
            of.is_allpass = true;
            of.final_section = 0u32;
        }
    }
}

/// A number of sections as a number at run time.
#[portable]
pub fn count(sections: usize) -> u32 {
    let mut count = 0u32;
    for i in 0..MAX_ORDER {
        if i < sections {
            count += 1u32;
        }
    }
    count
}

/// Reads the element whose turn it is.
#[portable]
pub fn pick<R: Real>(of: &mut Element<R>, turn: u32, coeffs: &Coeffs<R>, inputs: &Inputs<R>) {
    let mut of_stage = 0u32;
    for i in 0..STAGES {
        let mut of_filter = 0u32;
        for k in 0..FILTERS {
            if is_element(coeffs, i, k) && turn == place(coeffs, i, k) {
                of.stage = of_stage;
                of.filter = of_filter;
                read(of, coeffs, inputs, i, k);
            }
            of_filter += 1u32;
        }
        of_stage += 1u32;
    }
}

/// The turn of filter `k` of stage `i`: the number of elements before it.
#[portable]
pub fn place<R: Real>(coeffs: &Coeffs<R>, i: usize, k: usize) -> u32 {
    let mut before = 0u32;
    for stage in 0..STAGES {
        for filter in 0..FILTERS {
            if (stage < i || stage == i && filter < k) && is_element(coeffs, stage, filter) {
                before += 1u32;
            }
        }
    }
    before
}

/// Whether filter `k` of stage `i` exists.
#[portable]
pub fn is_element<R: Real>(coeffs: &Coeffs<R>, i: usize, k: usize) -> bool {
    coeffs.set.ipc.stage[i].mode != Mode::NotActive && coeffs.set.ipc.stage[i].filter[k].kind != Type::NoFilter
}

/// Whether filter `k` of stage `i` exists and is of this type.
#[portable]
pub fn is_of_type<R: Real>(coeffs: &Coeffs<R>, i: usize, k: usize, kind: Type) -> bool {
    is_element(coeffs, i, k) && coeffs.set.ipc.stage[i].filter[k].kind == kind
}

/// The number of elements.
#[portable]
pub fn elements<R: Real>(coeffs: &Coeffs<R>) -> u32 {
    place(coeffs, STAGES, 0usize)
}

/// Whether an element has a pair of poles.
#[portable]
pub fn has_pairs<R: Real>(coeffs: &Coeffs<R>) -> bool {
    let mut found = false;
    for i in 0..STAGES {
        for k in 0..FILTERS {
            found = found
                || is_of_type(coeffs, i, k, Type::Bandpass)
                    && has_pair(coeffs.prototype[i].filter[k], coeffs.set.ipc.stage[i].filter[k].order);
        }
    }
    found
}

/// Whether an element is in a stage after the first one.
#[portable]
pub fn has_later_stages<R: Real>(coeffs: &Coeffs<R>) -> bool {
    let mut found = false;
    for i in 1..STAGES {
        found = found || coeffs.set.ipc.stage[i].mode != Mode::NotActive;
    }
    found
}

/// Whether an element is the second filter of its stage.
#[portable]
pub fn has_later_filters<R: Real>(coeffs: &Coeffs<R>) -> bool {
    let mut found = false;
    for i in 0..STAGES {
        for k in 1..FILTERS {
            found = found || is_element(coeffs, i, k);
        }
    }
    found
}

/// Whether an element is a filter of this type.
#[portable]
pub fn has_type<R: Real>(coeffs: &Coeffs<R>, kind: Type) -> bool {
    let mut found = false;
    for i in 0..STAGES {
        for k in 0..FILTERS {
            found = found || is_of_type(coeffs, i, k, kind);
        }
    }
    found
}
