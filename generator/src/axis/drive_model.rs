//! What is known of the drive, for the stability of the loop that improved position control closes. Nothing in a block is made of it.

use std::sync::Arc;

/// The drive between the commanded velocity and the motor's, and the position controller around it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DriveModel {
    /// cycles after which the motor does what was commanded (`drive.delay`)
    pub delay_cycles: Option<f64>,
    /// time constant after that [s] (`drive.time_constant`)
    pub time_constant: Option<f64>,
    /// a measured response, in the place of both (`drive.response`)
    pub response: Option<MeasuredDrive>,
    /// gain of the position controller Kv [1/s] (P-AXIS-00099), where it is given
    pub position_gain: Option<f64>,
}

/// A measured response.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredDrive {
    /// its file, as it is named
    pub file: String,
    pub response: Arc<stability::Response>,
}

impl DriveModel {
    /// Whether somebody said what the drive does.
    #[must_use]
    pub fn is_given(&self) -> bool {
        self.delay_cycles.is_some() || self.time_constant.is_some() || self.response.is_some()
    }
}
