//! The pieces of a design. Each changes the state and selects the next piece.

use super::coeffs::Coeffs;
use super::element;
use super::signals::Inputs;
use super::state::{Piece, State};
use crate::check_word;
use crate::design::band::{cycle_time, warped};
use crate::design::inputs::{Wrong, check_filter, is_damping, is_weight};
use crate::design::sections::{self, Shape};
use crate::design::square_root::square_root;
use crate::design::{allpass, bandpass, limit as limits, narrow, oscillation};
use crate::filter::{MAX_ORDER, Type};
use crate::ipc::{STAGES, numbers, simulates, watch};
use crate::precision::is_single;
use crate::sets::check;
use crate::stage::{self, FILTERS};
use portable::{Real, in_range, note, portable};

/// smallest limit of v_add other than 0, 2^-20, so that single precision and the check word have all digits [um/s or 0.001 deg/s]
#[portable]
pub fn smallest_limit<R: Real>() -> R {
    R::lit(9.536_743_164_062_5e-7)
}

/// The limit. Returns whether it is outside its range.
#[portable]
pub fn limit<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> Wrong {
    let limit = inputs.limit;
    // A NaN is compared by `in_range` only.
    let mut is_sound = false;
    if in_range(limit, coeffs.set.ipc.limit) {
        is_sound = in_range(limit, R::ZERO) || limit >= smallest_limit();
    }
    if is_sound {
        state.limit = limit;
        let rounded = in_precision(limit);
        state.numbers.limit = rounded;
        state.numbers.lower_limit = limits::lower_limit(rounded);
        state.numbers.watch.quiet = in_precision(watch::quiet(limit));
        state.piece = Piece::Element;
    }
    if is_sound { Wrong::Nothing } else { Wrong::Limit }
}

/// A number in the precision of the block that takes the set.
#[portable]
pub fn in_precision<R: Real>(x: R) -> R {
    if is_single::<R>() { narrow::narrow(x) } else { x }
}

/// Reads the inputs of the element whose turn it is. Returns which one is outside its range.
#[portable]
pub fn inputs<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> Wrong {
    element::pick(&mut state.of, state.turn, coeffs, inputs);
    let mut wrong = check_filter(state.of.f0, state.of.q_factor, coeffs.lowest_f0, coeffs.highest_f0);
    if wrong == Wrong::Nothing {
        let is_sound = is_weight(state.of.weight);
        if !is_sound {
            wrong = Wrong::Weight;
        }
    }
    if wrong == Wrong::Nothing && state.of.is_simulated {
        let is_sound = is_damping(state.of.damping);
        if !is_sound {
            wrong = Wrong::Damping;
        }
    }
    if wrong == Wrong::Nothing {
        begin_element(state);
    } else {
        // The state keeps no number that was refused.
        state.of.f0 = R::ZERO;
        state.of.q_factor = R::ZERO;
        state.of.weight = R::ZERO;
        state.of.damping = R::ZERO;
    }
    wrong
}

/// The norm of the stage at its first element; then the centre.
#[portable]
pub fn begin_element<R: Real>(state: &mut State<R>) {
    if state.of.opens_stage {
        state.norm = state.of.weight;
        if state.of.is_simulated {
            state.norm = state.norm * limits::oscillation_norm(state.of.damping);
        }
    }
    state.piece = Piece::Centre;
}

/// The warped centre frequency, then the warped bandwidth.
#[portable]
pub fn tangent<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let is_centre = state.piece == Piece::Centre;
    let frequency = if is_centre { state.of.f0 } else { state.of.f0 / state.of.q_factor };
    let seconds = cycle_time::<R>(coeffs.set.ipc.cycle_time_ns);
    let warped = warped(frequency, seconds);
    state.part = 0u32;
    if is_centre {
        state.band.omega0 = warped;
        state.piece = Piece::Bandwidth;
    } else {
        state.band.bandwidth = (R::ONE + state.band.omega0 * state.band.omega0) * warped;
        let has_pair = element::has_pairs(coeffs) && state.of.has_pair;
        state.piece = if has_pair { Piece::Argument } else { Piece::Section };
    }
}

/// The argument of the next square root of a pair of poles.
#[portable]
pub fn argument<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    if element::has_pairs(coeffs) {
        let x = bandpass::argument(&mut state.of.pair, state.part, &state.band);
        state.argument = x;
    }
    state.piece = Piece::Root;
}

/// The square root. After the fifth one come the sections.
#[portable]
pub fn root<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    if element::has_pairs(coeffs) {
        let root = square_root(state.argument);
        bandpass::keep(&mut state.of.pair, state.part, root);
    }
    if state.part < 4u32 {
        state.part += 1u32;
        state.piece = Piece::Argument;
    } else {
        state.part = 0u32;
        state.piece = Piece::Section;
    }
}

/// The next section of the filter. After the last one the simulated oscillation that has its centre, or the next element.
#[portable]
pub fn section<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    if element::has_type(coeffs, Type::Allpass) && state.of.is_allpass {
        allpass_section(state, coeffs);
    } else {
        bandpass_section(state, coeffs);
    }
    if state.part < state.of.final_section {
        state.part += 1u32;
    } else if simulates(&coeffs.set.ipc.stage) && state.of.has_oscillation {
        state.piece = Piece::Oscillation;
    } else {
        state.piece = Piece::End;
    }
}

/// The all-pass of the element.
#[portable]
pub fn allpass_section<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let mut shape = Shape::<R>::default();
    allpass::section(&mut shape, &state.band);
    let mut made = crate::allpass::Coeffs::<R>::default();
    sections::allpass_numbers(&mut made, &shape);
    if is_single::<R>() {
        narrow::allpass_section(&mut made);
    }
    for i in 0..STAGES {
        for k in 0..FILTERS {
            if element::is_of_type(coeffs, i, k, Type::Allpass) && state.turn == element::place(coeffs, i, k) {
                crate::allpass::take(&mut state.numbers.stage[i].filter[k].allpass, &made);
            }
        }
    }
}

/// The section of the band-pass whose turn it is.
#[portable]
pub fn bandpass_section<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let mut shape = Shape::<R>::default();
    if !element::has_pairs(coeffs) || state.part < state.of.real {
        bandpass::real_section(&mut shape, state.of.sigma, &state.band);
    } else if state.part == state.of.real {
        bandpass::lower_section(&mut shape, &state.of.pair, &state.band);
    } else {
        bandpass::upper_section(&mut shape, &state.of.pair, &state.band);
    }
    let mut made = crate::bandpass::Coeffs::<R>::default();
    sections::bandpass_numbers(&mut made, &shape);
    if is_single::<R>() {
        narrow::bandpass_section(&mut made);
    }
    for i in 0..STAGES {
        for k in 0..FILTERS {
            for s in 0..MAX_ORDER {
                if element::is_of_type(coeffs, i, k, Type::Bandpass)
                    && s < coeffs.set.ipc.stage[i].filter[k].order
                    && state.turn == element::place(coeffs, i, k)
                    && state.part == element::count(s)
                {
                    crate::bandpass::take(&mut state.numbers.stage[i].filter[k].bandpass[s], &made);
                }
            }
        }
    }
}

/// The simulated oscillation with the centre of the element.
#[portable]
pub fn oscillation_section<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    if simulates(&coeffs.set.ipc.stage) {
        make_oscillation(state, coeffs);
    }
    state.piece = Piece::End;
}

/// Designs the simulated oscillation.
#[portable]
pub fn make_oscillation<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let mut shape = Shape::<R>::default();
    oscillation::section(&mut shape, state.band.omega0, state.of.damping);
    let mut made = crate::oscillation::Coeffs::<R>::default();
    sections::oscillation_numbers(&mut made, &shape);
    if is_single::<R>() {
        narrow::oscillation_section(&mut made);
    }
    for i in 0..STAGES {
        for k in 0..FILTERS {
            if element::is_element(coeffs, i, k)
                && stage::is_centre_of_oscillation(&coeffs.set.ipc.stage[i], k)
                && state.turn == element::place(coeffs, i, k)
            {
                crate::oscillation::take(&mut state.numbers.stage[i].oscillation, &made);
            }
        }
    }
}

/// The end of an element, and with the last one of a stage its gain. After the last element comes the check word.
#[portable]
pub fn end<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    if element::has_type(coeffs, Type::Allpass) && state.of.is_allpass {
        state.norm = state.norm * limits::allpass_norm();
    } else {
        state.norm = state.norm * limits::bandpass_norm();
    }
    if state.of.closes_stage {
        state.norms = state.norms + state.norm;
        let gain = in_precision(limits::gain(state.of.weight));
        put_gain(state, coeffs, gain);
    }
    if state.turn < element::elements(coeffs) - 1u32 {
        state.turn += 1u32;
        state.piece = Piece::Element;
    } else {
        let sum_limit = limits::sum_limit(state.norms, state.limit, coeffs.v_max);
        state.numbers.sum_limit = in_precision(sum_limit);
        check::start(&mut state.check, &coeffs.set, 0u32);
        state.piece = Piece::Seal;
    }
}

/// Writes the gain of the stage of the element whose turn it is.
#[portable]
pub fn put_gain<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, gain: R) {
    for i in 0..STAGES {
        for k in 0..FILTERS {
            if element::is_element(coeffs, i, k)
                && element::is_last(&coeffs.set.ipc.stage[i], k)
                && state.turn == element::place(coeffs, i, k)
            {
                state.numbers.stage[i].gain = gain;
            }
        }
    }
}

/// A piece of the number whose turn it is in the check word. After the last one the set is complete.
#[portable]
pub fn seal<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let mut is_done = false;
    if state.check.turn < check::length(&coeffs.set) {
        let turn = state.check.turn;
        numbers::pick(&mut state.check.picked, turn, &coeffs.set.ipc, &state.numbers, &state.numbers);
        is_done = check::add(&mut state.check, &coeffs.set);
    } else {
        note("the state was corrupted: the design ends without a set");
        state.works = false;
    }
    if is_done {
        state.set_id = check_word::set_id(&state.check.forming);
        state.complete = true;
        state.works = false;
        state.piece = Piece::Rest;
    }
}
