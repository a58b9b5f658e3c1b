//! One filter of a stage: nothing, a band-pass of order 1 to 3, or an all-pass.

use crate::{allpass, bandpass, change, section};
use portable::{Real, portable};

/// The highest order of a band-pass: so many sections.
pub const MAX_ORDER: usize = 3;

/// What a filter is.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Type {
    /// the input passes unchanged
    #[default]
    NoFilter,
    /// `order` band-pass sections in series
    Bandpass,
    /// one all-pass section
    Allpass,
}

/// Coefficients. Only those that `kind` and `order` name are used.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// what the filter is
    pub kind: Type,
    /// number of band-pass sections
    pub order: usize,
    /// the band-pass sections, in the order of their execution
    pub bandpass: [bandpass::Coeffs<R>; MAX_ORDER],
    /// the all-pass section
    pub allpass: allpass::Coeffs<R>,
}

/// State: one section for an all-pass, `order` sections for a band-pass.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the sections
    pub section: [section::State<R>; MAX_ORDER],
    /// the input, where nothing else forms its change
    pub input: change::State<R>,
}

/// Whether the filter takes the change of its input: in single precision its first section does, unless it is a band-pass section
/// behind a band-pass.
#[portable]
pub fn takes_change<R: Real>(coeffs: &Coeffs<R>, is_behind: bool) -> bool {
    section::is_driven_by_change::<R>() && (coeffs.kind == Type::Allpass || coeffs.kind == Type::Bandpass && !is_behind)
}

/// One cycle: takes the input and its change, gives the output. `is_behind`: a band-pass stands before the filter.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, change: R, is_behind: bool) -> R {
    let mut y = x;
    match coeffs.kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            for i in 0..MAX_ORDER {
                if i < coeffs.order {
                    if i == 0usize && !is_behind {
                        y = bandpass::step(&mut state.section[i], &coeffs.bandpass[i], y, change);
                    } else {
                        y = bandpass::step_behind(&mut state.section[i], &coeffs.bandpass[i], y);
                    }
                }
            }
        }
        Type::Allpass => {
            y = allpass::step(&mut state.section[0], &coeffs.allpass, y, change);
        }
    }
    y
}

/// Puts the state where a constant input `x` would have brought it; gives the output that belongs to it.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, is_behind: bool) -> R {
    let mut y = x;
    match coeffs.kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            for i in 0..MAX_ORDER {
                if i < coeffs.order {
                    if i == 0usize && !is_behind {
                        y = bandpass::preset(&mut state.section[i], &coeffs.bandpass[i], y);
                    } else {
                        y = bandpass::preset_behind(&mut state.section[i], &coeffs.bandpass[i], y);
                    }
                }
            }
        }
        Type::Allpass => {
            y = allpass::preset(&mut state.section[0], &coeffs.allpass, y);
        }
    }
    y
}
