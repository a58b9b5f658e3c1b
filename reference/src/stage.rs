//! One stage: the source that its mode names, the simulated oscillation, two filters, the gain.

use crate::{biquad, filter, section};
use portable::{Real, portable};

/// Filters in a stage.
pub const FILTERS: usize = 2;

/// Where a stage gets its vibration from.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// the stage is not there
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
    pub oscillation: biquad::Coeffs<R>,
    /// the filters, in the order of their execution
    pub filter: [filter::Coeffs<R>; FILTERS],
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

/// Whether the stage looks at the command velocity.
#[portable]
pub fn reads_command<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.mode == Mode::SetPoint
}

/// Whether the stage looks at the motor's velocity.
#[portable]
pub fn reads_motor<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.mode == Mode::Indirect || coeffs.mode == Mode::Direct && coeffs.direct_source == DirectSource::Motor
}

/// Whether the stage looks at the velocity of the direct measuring system.
#[portable]
pub fn reads_direct<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.mode == Mode::Direct && coeffs.direct_source == DirectSource::Direct
}

/// The velocity that the stage looks at.
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

/// One cycle: takes the velocity that the stage looks at, gives `gain * filter[1](filter[0](oscillation(x)))`.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) -> R {
    let mut y = x;
    if coeffs.mode != Mode::Direct {
        y = biquad::step(&mut state.oscillation, &coeffs.oscillation, y);
    }
    for k in 0..FILTERS {
        y = filter::step(&mut state.filter[k], &coeffs.filter[k], y);
    }
    coeffs.gain * y
}

/// Puts all sections where a constant `x` would have brought them.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, x: R) {
    let mut y = x;
    if coeffs.mode != Mode::Direct {
        y = biquad::preset(&mut state.oscillation, &coeffs.oscillation, y);
    }
    for k in 0..FILTERS {
        y = filter::preset(&mut state.filter[k], &coeffs.filter[k], y);
    }
}
