//! One stage: the source that its mode names, the simulated oscillation, two filters, the gain.

use crate::turn::{Picked, role_gain};
use crate::{change, filter, oscillation, section};
use portable::{Real, portable};

/// Filters in a stage.
pub const FILTERS: usize = 2;

/// Where a stage gets its vibration from.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// the stage does not exist
    #[default]
    NotActive,
    /// a measured velocity
    Direct,
    /// the oscillation simulated from the motor's velocity
    Indirect,
    /// the oscillation simulated from the command velocity
    SetPoint,
}

/// Which measured velocity a DIRECT stage takes.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DirectSource {
    /// the motor encoder
    #[default]
    Motor,
    /// the direct measuring system
    Direct,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// where the vibration comes from
    pub mode: Mode,
    /// which measured velocity a DIRECT stage takes
    pub direct_source: DirectSource,
    /// the simulated oscillation of INDIRECT and SET_POINT
    pub oscillation: oscillation::Coeffs<R>,
    /// the filters, in the order of their execution
    pub filter: [filter::Coeffs<R>; FILTERS],
    /// -weight: negative, because the stage moves the motor against the vibration
    pub gain: R,
}

/// The numbers of a stage that a parameter set may change. Every other coefficient is structure.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Numbers<R> {
    /// the simulated oscillation of INDIRECT and SET_POINT
    pub oscillation: oscillation::Coeffs<R>,
    /// the filters, in the order of their execution
    pub filter: [filter::Numbers<R>; FILTERS],
    /// -weight: negative, because the stage moves the motor against the vibration
    pub gain: R,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the simulated oscillation
    pub oscillation: section::State<R>,
    /// the filters
    pub filter: [filter::State<R>; FILTERS],
}

/// Whether the stage uses the command velocity.
#[portable]
pub fn reads_command<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.mode == Mode::SetPoint
}

/// Whether the stage uses the motor's velocity.
#[portable]
pub fn reads_motor<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.mode == Mode::Indirect || coeffs.mode == Mode::Direct && coeffs.direct_source == DirectSource::Motor
}

/// Whether the stage uses the velocity of the direct measuring system.
#[portable]
pub fn reads_direct<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.mode == Mode::Direct && coeffs.direct_source == DirectSource::Direct
}

/// The velocity that the stage uses.
#[portable]
pub fn source<R: Real>(coeffs: &Coeffs<R>, v_command: R, v_motor: R, v_direct: R) -> R {
    if reads_command(coeffs) {
        v_command
    } else if reads_direct(coeffs) {
        v_direct
    } else {
        v_motor
    }
}

/// Whether a band-pass precedes filter `k`, so that its input has no offset.
#[portable]
pub fn follows_bandpass<R: Real>(coeffs: &Coeffs<R>, k: usize) -> bool {
    let mut found = false;
    for before in 0..FILTERS {
        found = found || before < k && coeffs.filter[before].kind == filter::Type::Bandpass;
    }
    found
}

/// Whether no filter precedes filter `k`.
#[portable]
pub fn is_first<R: Real>(coeffs: &Coeffs<R>, k: usize) -> bool {
    let mut first = true;
    for before in 0..FILTERS {
        first = first && (before >= k || coeffs.filter[before].kind == filter::Type::NoFilter);
    }
    first
}

/// Whether the input of filter `k` is the velocity itself, whose change the block computes for all stages.
#[portable]
pub fn reads_source<R: Real>(coeffs: &Coeffs<R>, k: usize) -> bool {
    coeffs.mode == Mode::Direct && is_first(coeffs, k)
}

/// Whether filter `k` is the first band-pass of a stage with a simulated oscillation, which has its centre.
#[portable]
pub fn is_centre_of_oscillation<R: Real>(coeffs: &Coeffs<R>, k: usize) -> bool {
    coeffs.mode != Mode::Direct && coeffs.filter[k].kind == filter::Type::Bandpass && !follows_bandpass(coeffs, k)
}

/// Whether the stage computes the change of the input of filter `k` itself.
#[portable]
pub fn forms_change<R: Real>(coeffs: &Coeffs<R>, k: usize) -> bool {
    filter::takes_change(&coeffs.filter[k], follows_bandpass(coeffs, k)) && !reads_source(coeffs, k)
}

/// One cycle: takes the velocity that the stage uses and its change since the previous cycle, returns
/// `gain * filter[1](filter[0](oscillation(x)))`. Double precision does not use the change.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R, change: R) -> R {
    let mut y = x;
    if coeffs.mode != Mode::Direct {
        y = oscillation::step(&mut state.oscillation, &coeffs.oscillation, y, change);
    }
    for k in 0..FILTERS {
        let mut change_of_y = change;
        if forms_change(coeffs, k) {
            change_of_y = change::step(&mut state.filter[k].input, y);
        }
        y = filter::step(&mut state.filter[k], &coeffs.filter[k], y, change_of_y, follows_bandpass(coeffs, k));
    }
    coeffs.gain * y
}

/// Sets all sections to the steady state for a constant `x`.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) {
    let mut y = x;
    if coeffs.mode != Mode::Direct {
        y = oscillation::preset(&mut state.oscillation, &coeffs.oscillation, y);
    }
    for k in 0..FILTERS {
        if forms_change(coeffs, k) {
            change::preset(&mut state.filter[k].input, y);
        }
        y = filter::preset(&mut state.filter[k], &coeffs.filter[k], y, follows_bandpass(coeffs, k));
    }
}

/// largest |weight| (P-AXIS-00754/00755)
#[portable]
pub fn weight_limit<R: Real>() -> R {
    R::lit(7.0)
}

/// Copies the numbers of another stage of the same structure.
#[portable]
pub fn take<R: Real>(now: &mut Numbers<R>, structure: &Coeffs<R>, offered: &Numbers<R>) {
    if structure.mode != Mode::Direct {
        oscillation::take(&mut now.oscillation, &offered.oscillation);
    }
    for k in 0..FILTERS {
        filter::take(&mut now.filter[k], &structure.filter[k], &offered.filter[k]);
    }
    now.gain = offered.gain;
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
    if structure.mode != Mode::Direct {
        at = oscillation::pick(picked, turn, at, &numbers.oscillation, &copy.oscillation);
    }
    for k in 0..FILTERS {
        at = filter::pick(picked, turn, at, &structure.filter[k], &numbers.filter[k], &copy.filter[k]);
    }
    if turn == at {
        picked.number = numbers.gain;
        picked.copy = copy.gain;
        picked.role = role_gain();
    }
    at + 1u32
}
