//! The rules of a changeover in the drive: its operation modes, its feedforward, its delay.

use super::{offered, op_modes, velocities::asks};
use crate::axis::{Bus, Changeover, Feedforward, Location};
use crate::config::values::key;
use crate::parameters::words::{DriveType, FeedforwardWord, OperationMode, Words};
use crate::parameters::{Name, Value};
use crate::rules::drive;
use crate::rules::effective::{Effective, as_written, number_as_written};
use crate::{codes, diagnostics::Diagnostic};

/// The bus of a drive whose mode the CNC changes; `None` if no drive of this type allows it.
fn bus_of(drive_type: DriveType) -> Option<Bus> {
    match drive_type {
        DriveType::Sercos => Some(Bus::Sercos),
        DriveType::CanOpen => Some(Bus::CanOpen),
        DriveType::Conventional | DriveType::Profidrive | DriveType::Simulation | DriveType::Lightbus => None,
        DriveType::Terminal | DriveType::RtEthernet | DriveType::Virtual | DriveType::CanBus => None,
    }
}

/// The changeover of a drive that controls the position, or only the velocity; `None` after a reported error.
pub(super) fn check(
    e: &mut Effective<'_>,
    location: Location,
    feedforward: Option<&Feedforward>,
    is_alone: bool,
) -> Option<Changeover> {
    let Some(bus) = bus_of(e.validated_word(key(Name::DriveType))?).filter(|_| location == Location::Drive) else {
        no_changeover(e);
        return None;
    };
    if feedforward.is_some_and(|of| of.conventional.any() && !of.global_disable) {
        leads(e);
    }
    let modes = if is_alone { one_mode(e, bus) } else { modes(e, bus) };
    let feed_forward_v_weighting = weight(e);
    let width = e.word(key(Name::VelocityCommandData));
    let velocity = width.and_then(|width| drive::velocity(e, width));
    if velocity.is_some_and(|velocity| velocity.reso.num == 0) {
        let reso = key(Name::VResoNum);
        let found = format!("{} is 0: the velocity command of the drive is always 0", e.title(reso));
        let said = Diagnostic::error(codes::NO_VELOCITY, e.place_of(reso), found);
        e.report.push(said.allowed("1 <= v_reso_num [increments]").instead("v_reso_num with the scaling of the drive"));
    }
    let [position_mode, velocity_mode] = modes?;
    offered::check(e, bus, velocity_mode, is_alone);
    Some(Changeover::Drive {
        bus,
        position_mode,
        velocity_mode,
        feed_forward_v_weighting: feed_forward_v_weighting?,
        velocity: velocity?,
    })
}

/// Rejects position control in a drive that does not change its operation mode on demand.
fn no_changeover(e: &mut Effective<'_>) {
    let drive_type: Option<DriveType> = e.validated_word(key(Name::DriveType));
    let mode = key(Name::OperationMode);
    let at = if e.given(mode).is_some() { mode } else { key(Name::DriveType) };
    let found = format!(
        "the drive is {} (P-AXIS-00020) and controls the position (P-AXIS-00320): it does not change its operation mode for the CNC",
        drive_type.map_or("", Words::name)
    );
    let place = e.place_near(at, asks);
    let instead = as_written(&place, mode, &[OperationMode::CncPositionControl.name()]);
    let said = Diagnostic::error(codes::NO_CHANGEOVER, place, found);
    e.report.push(said.allowed("SERCOS or CANOPEN, or position control in the CNC").instead(instead));
}

/// The operation mode of a drive with velocity control alone, used for both modes.
fn one_mode(e: &mut Effective<'_>, bus: Bus) -> Option<[i32; 2]> {
    let name = match bus {
        Bus::Sercos => Name::OpModeForVelocityControl,
        Bus::CanOpen => Name::CyclicVelocityOpMode,
    };
    let mode = e.signed(key(name))?;
    if bus == Bus::CanOpen {
        op_modes::of_velocity(e, mode);
    }
    Some([mode; 2])
}

/// The operation modes of position and velocity control. They must differ, because the drive displays the active one.
fn modes(e: &mut Effective<'_>, bus: Bus) -> Option<[i32; 2]> {
    let modes = match bus {
        Bus::Sercos => [0, e.signed(key(Name::OpModeForVelocityControl))?],
        Bus::CanOpen => {
            let modes = [Name::CyclicPositionOpMode, Name::CyclicVelocityOpMode].map(|name| e.signed(key(name)));
            [modes[0]?, modes[1]?]
        }
    };
    if modes[0] != modes[1] {
        if bus == Bus::CanOpen {
            op_modes::check(e, modes);
        }
        return Some(modes);
    }
    let (at, found, allowed, instead) = match bus {
        Bus::Sercos => {
            let at = key(Name::OpModeForVelocityControl);
            let how = if e.given(at).is_some() { "is" } else { "has its default" };
            let found = format!("{} {how} 0, the main mode, which is that of position control", e.title(at));
            let allowed = "1, 2 or 3: an auxiliary mode of the drive (S-0-0033 to S-0-0035) with velocity control";
            let instead = number_as_written(&e.place_near(at, asks), at, 1) + ", if S-0-0033 is velocity control";
            (at, found, allowed, instead)
        }
        Bus::CanOpen => {
            let [position, velocity] = [Name::CyclicPositionOpMode, Name::CyclicVelocityOpMode].map(key);
            let at = if e.given(velocity).is_some() { velocity } else { position };
            let found = format!("{} and {} are both {}", e.title(position), e.title(velocity), modes[0]);
            (at, found, "two operation modes (6060h)", "8 for position control and 9 for velocity control".to_owned())
        }
    };
    let place = e.place_near(at, asks);
    let found = format!("{found}: the drive's answer could not be distinguished from the mode that it leaves");
    e.report.push(Diagnostic::error(codes::ONE_MODE, place, found).allowed(allowed).instead(instead));
    None
}

/// Weight of the drive's own feedforward: P-AXIS-00833, which replaces P-AXIS-00766.
fn weight(e: &mut Effective<'_>) -> Option<u32> {
    let [new, old] = [Name::FeedForwardVWeighting, Name::ChangeFeedForwardVWeighting].map(key);
    if e.given(old).is_some() {
        let adopted = e.validated_integer(old)?;
        if e.given(new).is_none() {
            e.adopt(new, Value::Integer(i64::from(adopted)));
        }
    }
    e.integer(new)
}

/// Rejects conventional feedforward: it leads the drive's position command by v_feedforward / Kv, which would be a step at
/// each changeover.
fn leads(e: &mut Effective<'_>) {
    let at = key(Name::FeedforwardMode);
    let words: Option<Vec<FeedforwardWord>> = e.validated_words(at);
    let words = words.unwrap_or_default().into_iter().map(Words::name).collect::<Vec<_>>().join(" ");
    let found = format!(
        "{} is {words}: it leads the position command of the drive, which would step at the changeover",
        e.title(at)
    );
    let said = Diagnostic::error(codes::STEP, e.place_of(at), found);
    e.report.push(
        said.allowed("NONE, or quantities with an additive output: ADD_VEL, ADD_ACC").instead(
            "ADD_VEL, or NONE and the feedforward of the drive (SERCOS S-0-0296, CANopen 3062h; P-AXIS-00833)",
        ),
    );
}

/// Cycles between command and actual value (P-AXIS-00191). The manuals disagree about its default.
pub(super) fn delay_cycles(e: &mut Effective<'_>, is_alone: bool) -> Option<u32> {
    let delay = key(Name::NbrDelayCycles);
    if is_alone && e.given(delay).is_none() {
        return Some(0);
    }
    if e.given(delay).is_some() {
        return e.integer(delay);
    }
    let found = format!(
        "{} is missing: the position command at the change to position control needs the cycles between a command and the \
         actual value that it causes",
        e.title(delay)
    );
    let said = Diagnostic::error(codes::MISSING, e.place_near(delay, asks), found);
    let allowed = delay.0.parameter().allowed();
    e.report
        .push(said.allowed(allowed).instead("antr.nbr_delay_cycles with the cycles of the bus, both ways together"));
    None
}
