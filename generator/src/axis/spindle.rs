//! The changeover of a spindle between position and velocity control, as plain data from the parameters.

use super::{Ratio, Velocity};

/// Automatic changeover of a spindle.
#[derive(Clone, Debug, PartialEq)]
pub struct Spindle {
    /// velocity above which M3 and M4 lead to velocity control [0.001 deg/s] (P-AXIS-00767, 00265)
    pub v_velocity_control_on: u32,
    /// velocity at which position control begins again [0.001 deg/s] (P-AXIS-00768, 00266)
    pub v_position_control_on: u32,
    pub drive: Changeover,
    /// weight of the CNC's feedforward of the velocity, of a drive that controls the position that of an additive velocity
    /// (P-AXIS-00228/00229)
    pub feedforward: Option<Ratio>,
    /// whether that feedforward is active despite G137 (P-AXIS-00255)
    pub default_active: bool,
    /// gain of the position controller, in the drive or in the CNC [0.01/s] (P-AXIS-00099); 0 for velocity control alone
    pub kv: u32,
    /// position control in the drive: cycles between sending a command and receiving the actual value that it caused
    /// (P-AXIS-00191); otherwise 0
    pub delay_cycles: u32,
    /// deceleration of the velocity command on the way to position control [0.001 deg/s^2] (key `spindle.deceleration`)
    pub deceleration: f64,
    /// smallest window around the velocity of position control [0.001 deg/s] (key `spindle.window`)
    pub window: f64,
    /// largest step of the position command when the interpolator takes over [0.001 deg] (key `spindle.takeover_window`)
    pub takeover_window: f64,
    /// time within which the drive displays the new mode [ns] (key `spindle.mode_timeout`)
    pub mode_timeout_ns: u64,
    /// time within which the spindle has braked [ns] (key `spindle.brake_timeout`)
    pub brake_timeout_ns: u64,
}

impl Spindle {
    /// Whether the drive offers velocity control alone: both velocities are 0, and the CNC has no position loop.
    #[must_use]
    pub fn only_velocity(&self) -> bool {
        let is_in_drive = matches!(self.drive, Changeover::Drive { .. });
        is_in_drive && self.v_velocity_control_on == 0 && self.v_position_control_on == 0
    }
}

/// The device that changes the mode.
#[derive(Clone, Debug, PartialEq)]
pub enum Changeover {
    /// position control in the CNC: only the CNC, by opening its loop
    Cnc,
    /// position control in the drive: the drive receives the mode and displays it
    Drive {
        bus: Bus,
        /// number of the operation mode of position control (P-AXIS-00463); for SERCOS 0, the main mode
        position_mode: i32,
        /// number of the operation mode of velocity control (P-AXIS-00464, 00264)
        velocity_mode: i32,
        /// weight of the feedforward in the drive [0.1 %] (P-AXIS-00833, 00766)
        feed_forward_v_weighting: u32,
        /// scaling of the velocity command
        velocity: Velocity,
    },
}

/// Drives that change their operation mode on demand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bus {
    Sercos,
    CanOpen,
}
