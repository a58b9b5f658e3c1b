//! The location of position control, and the drive's process data. No feedforward here.

use super::{effective::Effective, presence::Presence};
use crate::axis::{Location, Ratio, Resolution, TimeBase, Velocity, Width};
use crate::config::values::{Key, key};
use crate::parameters::words::{DriveType, OperationMode, ProcessDatum};
use crate::parameters::{Name, Value};
use crate::{codes, diagnostics::Diagnostic};

/// The parameters of the drive that every part of the axis needs.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Drive {
    pub(crate) location: Location,
    /// whether a parameter states the location
    pub(crate) is_stated: bool,
    /// the gear step in use
    pub(crate) gear: u32,
    pub(crate) velocity: Option<Width>,
    pub(crate) torque: Option<Width>,
}

impl Drive {
    /// Scaling of the additive velocity (P-AXIS-00205 to 00207), where it is put out; `None` after a reported error.
    pub(crate) fn velocity(&self, e: &mut Effective<'_>, is_put_out: bool) -> Option<Presence<Velocity>> {
        let Some(width) = self.velocity.filter(|_| is_put_out) else { return Some(Presence::Absent) };
        let velocity = velocity(e, width);
        note(e, &[Name::AdditiveVelocityData]);
        Some(Presence::Present(velocity?))
    }

    /// Reports that the increments per revolution of the gear step are 0 (P-AXIS-00092) although they are needed.
    pub(crate) fn no_increments(&self, e: &mut Effective<'_>, why: &str) {
        let key = (Name::IncrPerRev, [self.gear, 0]);
        let found = format!("{} is 0, and {why}", e.title(key));
        let diagnostic = Diagnostic::error(codes::RESOLUTION, e.place_of(key), found);
        e.report.push(diagnostic.allowed("1 <= incr_per_rev [increments/revolution]"));
    }
}

/// The location of position control (P-AXIS-00320), by default from the drive type (P-AXIS-00020); `None` after a reported
/// error.
pub(crate) fn check(e: &mut Effective<'_>) -> Option<Drive> {
    let gear = e.validated_integer(key(Name::Gear))?;
    let drive_type = e.validated_word(key(Name::DriveType))?;
    let (in_drive, is_stated) = match e.validated_word(key(Name::OperationMode))? {
        OperationMode::DrivePositionControl => (true, true),
        OperationMode::CncPositionControl => (false, true),
        OperationMode::DriveDefault => (controls_position(drive_type), e.given(key(Name::DriveType)).is_some()),
    };
    let location = if in_drive { in_drive_of(drive_type) } else { Location::Cnc };
    let velocity = datum(e, Name::AdditiveVelocityData);
    Some(Drive { location, is_stated, gear, velocity, torque: datum(e, Name::AdditiveTorqueData) })
}

/// Scaling of the velocity for a drive that controls the position (P-AXIS-00205 to 00207).
pub(crate) fn velocity(e: &mut Effective<'_>, width: Width) -> Option<Velocity> {
    let reso = ratio(e, key(Name::VResoNum), key(Name::VResoDenom));
    let time_base = e.integer(key(Name::VTimeBase)).and_then(|base| TimeBase::ALL.get(base as usize).copied());
    Some(Velocity { reso: reso?, time_base: time_base?, width })
}

fn controls_position(drive_type: DriveType) -> bool {
    match drive_type {
        DriveType::Sercos | DriveType::Profidrive | DriveType::CanOpen => true,
        DriveType::Conventional | DriveType::Simulation | DriveType::Lightbus | DriveType::Terminal => false,
        DriveType::RtEthernet | DriveType::Virtual | DriveType::CanBus => false,
    }
}

/// The location of a position controller in a drive.
fn in_drive_of(drive_type: DriveType) -> Location {
    match drive_type {
        DriveType::Profidrive => Location::Profidrive,
        DriveType::Sercos | DriveType::CanOpen | DriveType::Conventional | DriveType::Simulation => Location::Drive,
        DriveType::Lightbus | DriveType::Terminal | DriveType::RtEthernet | DriveType::Virtual => Location::Drive,
        DriveType::CanBus => Location::Drive,
    }
}

/// A process datum; `None` if the drive does not have it.
fn datum(e: &mut Effective<'_>, name: Name) -> Option<Width> {
    match e.validated_word(key(name))? {
        ProcessDatum::None => None,
        ProcessDatum::Int16 => Some(Width::Int16),
        ProcessDatum::Int32 => Some(Width::Int32),
    }
}

/// The delay of the drive that the axis states [cycles], and where: the key `drive.delay`, else P-AXIS-00191. A value out of
/// range is left to its own rule; no drive answers in the cycle of its command.
pub(crate) fn stated_delay(e: &Effective<'_>) -> Option<(f64, &'static str)> {
    let stated = [(Name::DriveDelay, "drive.delay"), (Name::NbrDelayCycles, "P-AXIS-00191")];
    let stated = stated.into_iter().find_map(|(name, whose)| Some((given_number(e, name)?, whose)));
    stated.filter(|(cycles, _)| (1.0..=1000.0).contains(cycles))
}

/// Warns of a key `drive.delay` below P-AXIS-00191, which it replaces. With a measured response it is only the part that the
/// measurement lacks; an option of the command line is a trial.
pub(crate) fn shorter_delay(e: &mut Effective<'_>) {
    let [delay, cycles] = [Name::DriveDelay, Name::NbrDelayCycles];
    let (Some(stated), Some(least)) = (given_number(e, delay), given_number(e, cycles)) else { return };
    let is_key = e.given(key(delay)).is_some_and(|setting| !setting.source.is_option());
    if !is_key || stated >= least || e.given(key(Name::DriveResponse)).is_some() {
        return;
    }
    let title = e.title(key(cycles));
    let found =
        format!("{} is {stated}, and {title} is {least}: the loops are tested with {stated}", e.title(key(delay)));
    let instead = format!("drive.delay = {least}, or more; or {title} with the number of cycles that was measured");
    e.warn(codes::SHORTER_DELAY, key(delay), found, Some(instead));
}

/// A number or a time [ns] that is given, in range or not.
pub(crate) fn given_number(e: &Effective<'_>, name: Name) -> Option<f64> {
    match *e.given(key(name))?.value.as_ref()? {
        Value::Real(x) => Some(x),
        Value::Integer(n) => Some(n as f64),
        Value::Duration(ns) => Some(ns as f64),
        Value::Word(_) | Value::Words(_) | Value::Text(_) => None,
    }
}

/// Adds parameters without indices that determine a block to the canonical form.
pub(crate) fn note(e: &mut Effective<'_>, names: &[Name]) {
    for name in names {
        if let Some(value) = e.validated(key(*name)) {
            e.note(key(*name), &value);
        }
    }
}

/// Path resolution (P-AXIS-00092, 00233, 00234, 00362, 00363).
pub(crate) fn resolution(e: &mut Effective<'_>, gear: u32) -> Option<Resolution> {
    gear_ratio(e, gear);
    let incr_per_rev = e.integer((Name::IncrPerRev, [gear, 0]));
    let wegauf = ratio(e, (Name::WegaufZ, [gear, 0]), (Name::WegaufN, [gear, 0]));
    let feed_const = ratio(e, key(Name::FeedConstNum), key(Name::FeedConstDenom));
    Some(Resolution { incr_per_rev: incr_per_rev?, wegauf: wegauf?, feed_const: feed_const? })
}

/// The gear ratio of P-AXIS-00511 and 00512 must be 1, because the formulas of the feedforward manual do not contain it.
fn gear_ratio(e: &mut Effective<'_>, gear: u32) {
    let [num, denom] = [Name::GearFactNum, Name::GearFactDenom].map(|name| (name, [gear, 0]));
    let (Some(of), Some(to)) = (e.validated_integer(num), e.validated_integer(denom)) else { return };
    if of != to {
        let given = if e.given(num).is_some() { num } else { denom };
        let found = format!("the gear ratio {of}/{to} (P-AXIS-00511, 00512) would not reach the angle of the motor");
        let wegauf = [Name::WegaufZ, Name::WegaufN].map(|name| e.validated_integer((name, [gear, 0])));
        let there = if wegauf == [Some(of), Some(to)] {
            format!("wegaufz and wegaufn are {of} and {to} already")
        } else {
            format!("getriebe[{gear}].wegaufz {of} and getriebe[{gear}].wegaufn {to}, in addition to the feed constant")
        };
        let instead = format!("no gear_fact_num and gear_fact_denom; {there}");
        let said = Diagnostic::error(codes::GEAR_RATIO, e.place_of(given), found);
        e.report.push(said.allowed("the ratio in P-AXIS-00234 and 00233 alone").instead(instead));
    }
}

/// Two parameters as a quotient; the range keeps the denominator above 0.
pub(crate) fn ratio(e: &mut Effective<'_>, num: Key, denom: Key) -> Option<Ratio> {
    let (num, denom) = (e.integer(num), e.integer(denom));
    Some(Ratio { num: num?, denom: denom? })
}
