//! Where the position is controlled, and what the drive's process data hold. No feedforward here.

use super::effective::Effective;
use crate::axis::{Place, Ratio, Resolution, TimeBase, Velocity, Width};
use crate::config::Key;
use crate::parameters::{Name, Value};

/// The drive, as far as every part of the axis needs it.
#[derive(Clone, Copy, Debug)]
pub struct Drive {
    /// where the position is controlled
    pub place: Place,
    /// the gear step whose parameters are used
    pub gear: u32,
    /// the additive velocity in the process data
    pub velocity: Option<Width>,
    /// the additive torque in the process data
    pub torque: Option<Width>,
}

impl Drive {
    /// What is judged where the drive could not be.
    pub const UNKNOWN: Self = Self { place: Place::Cnc, gear: 0, velocity: None, torque: None };
}

/// Where the position is controlled (P-AXIS-00320), by default as the drive type says (P-AXIS-00020); none: an error, which has
/// been said.
pub fn check(e: &mut Effective<'_>) -> Option<Drive> {
    let Some(Value::Integer(gear)) = e.judged((Name::Gear, [0, 0])) else { return None };
    let drive_type = e.judged(key(Name::DriveType))?;
    let is_profidrive = drive_type == Value::Word("PROFIDRIVE");
    let controls = matches!(drive_type, Value::Word("SERCOS" | "PROFIDRIVE" | "CANOPEN"));
    let in_drive = match e.judged(key(Name::OperationMode))? {
        Value::Word("DRIVE_POSITION_CONTROL") => true,
        Value::Word("CNC_POSITION_CONTROL") => false,
        _ => controls,
    };
    let place = match (in_drive, is_profidrive) {
        (false, _) => Place::Cnc,
        (true, false) => Place::Drive,
        (true, true) => Place::Profidrive,
    };
    Some(Drive {
        place,
        gear: u32::try_from(gear).ok()?,
        velocity: datum(e, Name::AdditiveVelocityData),
        torque: datum(e, Name::AdditiveTorqueData),
    })
}

/// The key of a parameter without indices.
pub fn key(name: Name) -> Key {
    (name, [0, 0])
}

/// A process datum; none: the drive does not have it.
fn datum(e: &mut Effective<'_>, name: Name) -> Option<Width> {
    match e.judged(key(name))? {
        Value::Word(word) => width(word),
        _ => None,
    }
}

/// The type of a process datum.
pub fn width(word: &str) -> Option<Width> {
    match word {
        "INT16" => Some(Width::Int16),
        "INT32" => Some(Width::Int32),
        _ => None,
    }
}

/// Notes that the place of position control decides something in a block.
pub fn note_place(e: &mut Effective<'_>) {
    for name in [Name::DriveType, Name::OperationMode] {
        if let Some(value) = e.judged(key(name)) {
            e.note(key(name), &value);
        }
    }
}

/// Scaling of the additive velocity (P-AXIS-00205 to 00207).
pub fn velocity(e: &mut Effective<'_>, width: Width) -> Option<Velocity> {
    let reso = ratio(e, key(Name::VResoNum), key(Name::VResoDenom));
    let time_base = e.integer(key(Name::VTimeBase)).map(|base| match base {
        0 => TimeBase::Minute,
        1 => TimeBase::Second,
        _ => TimeBase::Cycle,
    });
    note_datum(e, Name::AdditiveVelocityData);
    Some(Velocity { reso: reso?, time_base: time_base?, width })
}

/// Notes the width of a process datum that is put out.
pub fn note_datum(e: &mut Effective<'_>, name: Name) {
    if let Some(value) = e.judged(key(name)) {
        e.note(key(name), &value);
    }
}

/// Path resolution (P-AXIS-00092, 00233, 00234, 00362, 00363).
pub fn resolution(e: &mut Effective<'_>, gear: u32) -> Option<Resolution> {
    let incr_per_rev = e.integer((Name::IncrPerRev, [gear, 0]));
    let wegauf = ratio(e, (Name::WegaufZ, [gear, 0]), (Name::WegaufN, [gear, 0]));
    let feed_const = ratio(e, key(Name::FeedConstNum), key(Name::FeedConstDenom));
    Some(Resolution { incr_per_rev: incr_per_rev?, wegauf: wegauf?, feed_const: feed_const? })
}

/// Two parameters as a quotient; the range keeps the denominator above 0.
pub fn ratio(e: &mut Effective<'_>, num: Key, denom: Key) -> Option<Ratio> {
    let (num, denom) = (e.integer(num), e.integer(denom));
    Some(Ratio { num: num?, denom: denom? })
}
