//! A spindle that changes over: its drive, and the interpolator that moves it. Angles are in 0.001 deg.

pub mod drive;
pub mod interpolator;
