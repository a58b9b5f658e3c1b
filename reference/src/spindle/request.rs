//! What a spindle is asked to do. Data only.

use portable::portable;

/// What the interpolator has to do.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Job {
    /// M5, and what stops the spindle otherwise
    #[default]
    Stop,
    /// M3 or M4
    Turn,
    /// M19
    Orient,
    /// S[PUTAX]
    Release,
    /// G74
    Home,
}

/// A job with what belongs to it.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Request<R> {
    /// what to do
    pub kind: Job,
    /// how fast, below 0 in negative direction [0.001 deg/s]
    pub speed: R,
    /// where to [0.001 deg]
    pub position: R,
}

/// Which request inputs were TRUE in the last cycle.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Before {
    /// turn in positive direction
    pub m3: bool,
    /// turn in negative direction
    pub m4: bool,
    /// stop
    pub m5: bool,
    /// stop at a position
    pub m19: bool,
    /// give the axis away
    pub putax: bool,
    /// homing
    pub g74: bool,
}
