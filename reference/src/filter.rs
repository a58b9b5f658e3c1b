//! One filter of a stage: nothing, a band-pass of order 1 to 3, or an all-pass.

use crate::turn::Picked;
use crate::{allpass, bandpass, change, section};
use portable::{Real, portable};

/// The highest order of a band-pass, which is its number of sections.
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

/// The numbers of a filter that a parameter set may change. Every other coefficient is structure.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Numbers<R> {
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
    /// previous input, if the filter computes the change of its input itself
    pub input: change::State<R>,
}

/// Whether the filter uses the change of its input: in single precision its first section does, unless it is a band-pass section
/// after a band-pass.
#[portable]
pub fn takes_change<R: Real>(coeffs: &Coeffs<R>, follows_bandpass: bool) -> bool {
    section::is_driven_by_change::<R>()
        && (coeffs.kind == Type::Allpass || coeffs.kind == Type::Bandpass && !follows_bandpass)
}

/// One cycle: takes the input and its change, returns the output. `follows_bandpass`: a band-pass precedes the filter.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, change: R, follows_bandpass: bool) -> R {
    let mut y = x;
    match coeffs.kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            for i in 0..MAX_ORDER {
                if i < coeffs.order {
                    if i == 0usize && !follows_bandpass {
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

/// Sets the state to the steady state for a constant input `x`; returns the steady output.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, follows_bandpass: bool) -> R {
    let mut y = x;
    match coeffs.kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            for i in 0..MAX_ORDER {
                if i < coeffs.order {
                    if i == 0usize && !follows_bandpass {
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

/// Copies the numbers of another filter of the same structure.
#[portable]
pub fn take<R: Real>(now: &mut Numbers<R>, structure: &Coeffs<R>, offered: &Numbers<R>) {
    match structure.kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            for i in 0..MAX_ORDER {
                if i < structure.order {
                    bandpass::take(&mut now.bandpass[i], &offered.bandpass[i]);
                }
            }
        }
        Type::Allpass => allpass::take(&mut now.allpass, &offered.allpass),
    }
}

/// Picks the number whose turn it is, its copy, and what it is; turns are numbered from `first`. Returns the turn after the last
/// one.
#[portable]
pub fn pick<R: Real>(
    picked: &mut Picked<R>,
    turn: u32,
    first: u32,
    structure: &Coeffs<R>,
    numbers: &Numbers<R>,
    copy: &Numbers<R>,
) -> u32 {
    let mut at = first;
    match structure.kind {
        Type::NoFilter => {}
        Type::Bandpass => {
            for i in 0..MAX_ORDER {
                if i < structure.order {
                    at = bandpass::pick(picked, turn, at, &numbers.bandpass[i], &copy.bandpass[i]);
                }
            }
        }
        Type::Allpass => {
            at = allpass::pick(picked, turn, at, &numbers.allpass, &copy.allpass);
        }
    }
    at
}
