//! An independent model.

pub mod agree;
pub mod axis;
pub mod coefficients;
pub mod exact;
pub mod feedforward;
pub mod history;
pub mod ipc;
pub mod parameters;
pub mod position_control;
pub mod random;
pub mod rounding;
pub mod sections;
pub mod subject;
