//! The known behaviour of the drive, for the stability of the loop that improved position control closes. No block depends
//! on it.

use std::sync::Arc;

/// The drive between the commanded velocity and the motor's, and the position controller around it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DriveModel {
    /// cycles until the motor follows the command (`drive.delay`, else P-AXIS-00191)
    pub delay_cycles: Option<f64>,
    /// time constant after that [s] (`drive.time_constant`)
    pub time_constant: Option<f64>,
    /// a measured response, which contains both (`drive.response`)
    pub response: Option<MeasuredDrive>,
    /// gain of the position controller Kv [1/s] (P-AXIS-00099), if given
    pub position_gain: Option<f64>,
}

/// A measured response.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredDrive {
    /// its file, as named in the set
    pub file: String,
    pub response: Arc<stability::Response>,
    /// the part of it that is a delay outside of a position loop in the drive [s]
    pub delay: f64,
}

impl MeasuredDrive {
    /// The same drive, if it controls the position with a gain Kv [1/s].
    #[must_use]
    pub fn in_position_loop(self, gain: Option<f64>) -> Self {
        let Some(gain) = gain else { return self };
        let response = Arc::unwrap_or_clone(self.response).in_position_loop(gain, self.delay);
        Self { response: Arc::new(response), ..self }
    }
}

impl DriveModel {
    /// Whether the behaviour of the drive is given.
    #[must_use]
    pub fn is_given(&self) -> bool {
        self.delay_cycles.is_some() || self.time_constant.is_some() || self.response.is_some()
    }
}
