//! A spindle that changes over: its drive, the interpolator that moves it, the operator who asks for its jobs. Angles are in 0.001 deg.

pub mod display;
pub mod drive;
pub mod interpolator;
pub mod operator;
