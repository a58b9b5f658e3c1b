//! The requests to a spindle. Data only.

use portable::portable;

/// What the interpolator has to do.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Job {
    /// M5; also a reset, a fault or a drive that is off
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

/// A job with its data.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Request<R> {
    /// kind of the request or job
    pub kind: Job,
    /// speed, below 0 in negative direction [0.001 deg/s]
    pub speed: R,
    /// target position [0.001 deg]
    pub position: R,
}

/// The request inputs that were TRUE in the last cycle.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Before {
    /// request m3 of the previous cycle
    pub m3: bool,
    /// request m4 of the previous cycle
    pub m4: bool,
    /// request m5 of the previous cycle
    pub m5: bool,
    /// request m19 of the previous cycle
    pub m19: bool,
    /// request putax of the previous cycle
    pub putax: bool,
    /// request g74 of the previous cycle
    pub g74: bool,
    /// whether any request of the previous cycle was TRUE
    pub any: bool,
}
