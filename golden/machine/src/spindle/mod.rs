//! A spindle that changes over: its drive, its interpolator, its operator. Angles are in 0.001 deg.

pub mod display;
pub mod drive;
pub mod interpolator;
pub mod operator;
