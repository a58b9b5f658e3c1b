//! Feedforward, position control, gantry, spindle: everything around improved position control, as plain data from the
//! parameters.

use super::Spindle;
use crate::parameters::words::{AxisType, DriveType, Motor, Width};
use reference::position_control::Location;

/// All parameters of an axis except improved position control.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Control {
    pub feedforward: Option<Feedforward>,
    pub position_control: Option<PositionControl>,
    /// changeover of a spindle
    pub spindle: Option<Spindle>,
    /// logical axis number (P-AXIS-00016)
    pub number: u32,
    /// whether it is a rotary axis or a spindle (P-AXIS-00018): its velocities are in 0.001 deg/s, else in um/s
    pub is_rotary: bool,
    /// whether it is a spindle (P-AXIS-00018)
    pub is_spindle: bool,
    /// on a gantry slave: logical axis number of its master (P-AXIS-00070)
    pub master: Option<u32>,
    /// on a gantry slave whose master is known: largest |v_add| of the master [um/s or 0.001 deg/s]
    pub master_limit: Option<f64>,
    /// on the master of a gantry whose stages act: the names of its slaves
    pub slaves: Vec<String>,
    /// parameters that scale or limit something and were not given, with their defaults
    pub assumed: Vec<String>,
    /// where the position is controlled (P-AXIS-00320, P-AXIS-00020), if one of both says it
    pub location: Option<Location>,
    /// drive type (P-AXIS-00020), where it is given
    pub drive_type: Option<DriveType>,
    /// gain of the position controller [0.01/s] (P-AXIS-00099), where it is given or used; a drive that controls the
    /// position has the same
    pub kv: Option<u32>,
}

impl Control {
    /// The units of a fine path, and of a velocity as scalings have it.
    pub(crate) fn scaling_units(&self) -> [&'static str; 2] {
        if self.is_rotary { ["0.0001 deg", "1000 deg/min"] } else { ["0.1 um", "1 m/min"] }
    }

    /// Whether only improved position control is asked for.
    pub(crate) fn is_empty(&self) -> bool {
        self.feedforward.is_none() && self.position_control.is_none() && self.spindle.is_none()
    }

    /// Whether SET_POINT takes the output of the position controller, which contains the position: in the CNC, and where
    /// nothing says where the position is controlled. Else it takes the velocity of the interpolator.
    #[must_use]
    pub fn commands_by_position(&self) -> bool {
        self.location.is_none_or(|location| location == Location::Cnc)
    }

    /// A gain of the position controller, where it is: in the CNC, and in the drive.
    #[must_use]
    pub fn placed(&self, gain: Option<f64>) -> [Option<f64>; 2] {
        if self.commands_by_position() { [gain, None] } else { [None, gain] }
    }

    /// P-AXIS-00018.
    pub(crate) fn axis_type(&self) -> AxisType {
        match (self.is_spindle, self.is_rotary) {
            (true, _) => AxisType::Spindle,
            (false, true) => AxisType::Rotator,
            (false, false) => AxisType::Translator,
        }
    }

    pub(crate) fn velocity_unit(&self) -> &'static str {
        if self.is_rotary { "0.001 deg/s" } else { "um/s" }
    }
}

/// A quotient of two parameters, as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    pub num: u32,
    /// above 0
    pub denom: u32,
}

impl Ratio {
    /// 0: the weight after a correction.
    pub(crate) const ZERO: Self = Self { num: 0, denom: 1 };

    /// num / denom, rounded once.
    pub fn value(self) -> f64 {
        f64::from(self.num) / f64::from(self.denom)
    }
}

/// Which planned quantities go to one destination.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Quantities {
    pub velocity: bool,
    pub acceleration: bool,
    pub jerk: bool,
}

impl Quantities {
    pub fn any(self) -> bool {
        self.velocity || self.use_time()
    }

    /// Whether one of them is weighted with the time constant of the acceleration.
    pub(crate) fn use_time(self) -> bool {
        self.acceleration || self.jerk
    }

    /// The union of both.
    pub(crate) fn with(self, other: Self) -> Self {
        let [velocity, acceleration] = [self.velocity || other.velocity, self.acceleration || other.acceleration];
        Self { velocity, acceleration, jerk: self.jerk || other.jerk }
    }
}

/// Feedforward (P-AXIS-00223).
#[derive(Clone, Debug, PartialEq)]
pub struct Feedforward {
    /// what is added to the position controller's output
    pub conventional: Quantities,
    /// what goes to the drive as an additive velocity
    pub additive: Quantities,
    /// what goes to the drive as an additive torque
    pub torque: Quantities,
    /// active despite G137 (P-AXIS-00255)
    pub default_active: bool,
    /// inactive despite G135 (P-AXIS-00256)
    pub global_disable: bool,
    /// weight of the whole (P-AXIS-00228/00229)
    pub weight: Ratio,
    /// of the acceleration: time constant [us], with an additive torque a plain weight (P-AXIS-00225/00226)
    pub acceleration: Ratio,
    /// factor of the jerk (P-AXIS-00337/00338)
    pub jerk: Ratio,
    /// delay of the additive velocity [us] (P-AXIS-00389)
    pub velocity_delay: u32,
    /// delay of the additive torque of the acceleration [us] (P-AXIS-00390)
    pub acceleration_delay: u32,
    /// delay of the additive torque of the jerk [us] (P-AXIS-00547)
    pub jerk_delay: u32,
    /// scaling of the additive velocity, where it is put out
    pub velocity: Option<Velocity>,
    /// scaling of the additive torque, where it is put out
    pub torque_scale: Option<Torque>,
}

impl Feedforward {
    /// The weight of the acceleration as an additive torque: that of the whole times the plain one.
    pub(crate) fn torque_weight(&self) -> f64 {
        self.weight.value() * self.acceleration.value()
    }

    /// The quantities that are output as a velocity, to the position controller or to the drive.
    pub(crate) fn sums(&self) -> Quantities {
        self.conventional.with(self.additive)
    }
}

/// Scaling of an additive velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Velocity {
    /// increments per path (P-AXIS-00206/00205)
    pub reso: Ratio,
    pub time_base: TimeBase,
    pub width: Width,
}

/// Time base of a velocity (P-AXIS-00207).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeBase {
    Minute = 0,
    Second = 1,
    Cycle = 2,
}

impl TimeBase {
    /// All time bases, by their numbers.
    pub(crate) const ALL: [Self; 3] = [Self::Minute, Self::Second, Self::Cycle];
}

impl Width {
    /// The smallest and the largest value.
    pub(crate) fn range(self) -> [i32; 2] {
        match self {
            Self::Int16 => [i32::from(i16::MIN), i32::from(i16::MAX)],
            Self::Int32 => [i32::MIN, i32::MAX],
        }
    }
}

/// Path resolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    /// increments per revolution of the motor (P-AXIS-00092)
    pub incr_per_rev: u32,
    /// wegaufz / wegaufn (P-AXIS-00234/00233)
    pub wegauf: Ratio,
    /// feed constant [0.1 um or 0.0001 deg per revolution] (P-AXIS-00362/00363)
    pub feed_const: Ratio,
}

impl Resolution {
    /// Whether there is a feed constant: one of its parameters is not 1.
    pub(crate) fn has_feed_const(&self) -> bool {
        self.feed_const != Ratio { num: 1, denom: 1 }
    }
}

/// Scaling of an additive torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torque {
    /// of a rotary motor
    pub resolution: Resolution,
    /// key `motor`
    pub motor: Motor,
    /// total load [kg m^2], of a linear motor [kg] (P-AXIS-00391)
    pub load: f64,
    /// nominal torque [Nm], of a linear motor force [N]; above 0 (P-AXIS-00392)
    pub reference: f64,
    /// increments at the nominal torque (P-AXIS-00325/00326)
    pub scale: Ratio,
    pub width: Width,
}

#[derive(Clone, Debug, PartialEq)]
pub struct PositionControl {
    /// P-AXIS-00320, P-AXIS-00020
    pub location: Location,
    /// gain of the position controller [0.01/s] (P-AXIS-00099)
    pub kv: u32,
    /// position control in the CNC: value of the drive's velocity command at 1 m/min or 1000 deg/min (P-AXIS-00129/00128)
    pub multi_gain: Ratio,
    /// its process data
    pub command: Width,
    /// additive velocity command, where it is put out
    pub velocity: Option<Velocity>,
    /// PROFIdrive: path resolution
    pub resolution: Option<Resolution>,
    /// PROFIdrive: cycles by which the feedforward leads the position (P-AXIS-00165)
    pub shift_time: u32,
}

impl PositionControl {
    /// The process data through which an additive velocity reaches a drive that controls the position.
    pub(crate) const ADDITIVE_VELOCITY: &str = "SERCOS S-0-0037, CANopen 60B1h, PROFIdrive NSOLL_B";

    /// Whether v_add reaches the drive: in the velocity command of the CNC, or as an additive velocity.
    pub(crate) fn passes_v_add(&self) -> bool {
        self.location == Location::Cnc || self.velocity.is_some()
    }
}
