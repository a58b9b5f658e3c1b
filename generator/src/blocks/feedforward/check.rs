//! The rules of feedforward: the available quantities, their destinations, and corrections.

use crate::axis::{Feedforward, Location, Quantities, Ratio, Torque};
use crate::parameters::words::{AddJerk, AxisType, Boolean, FeedforwardWord, Motor, Words};
use crate::parameters::{Name, Value};
use crate::rules::drive::{self, Drive};
use crate::rules::{corrected, effective::Effective};
use crate::{codes, config::values::key, diagnostics::Diagnostic};

/// Feedforward of one axis. Outer `None` after a reported error; inner `None` without feedforward.
pub(crate) fn check(e: &mut Effective<'_>, cycle_time: Option<u32>, drive: &Drive) -> Option<Option<Feedforward>> {
    let words: Vec<FeedforwardWord> = e.validated_words(key(Name::FeedforwardMode))?;
    let has = |word| words.contains(&word);
    if has(FeedforwardWord::None) || words.is_empty() {
        return Some(None);
    }
    e.note(key(Name::FeedforwardMode), &Value::Words(words.iter().map(|word| word.name()).collect()));
    drive::note(e, &[Name::DriveType, Name::OperationMode]);
    refuse_jerk(e, has(FeedforwardWord::AddJerk))?;
    let mut ways = possible_ways(e, &words, drive);
    without_delay(e, &words)?;
    let default_active = e.word::<Boolean>(key(Name::DefaultActive)).map(|word| word == Boolean::True);
    let global_disable = e.word::<Boolean>(key(Name::GlobalDisable)).map(|word| word == Boolean::True);
    let [weight, acceleration, jerk] = weights(e, &mut ways);
    let [conventional, additive, mut torque] = ways;
    let mut delay = |is_used: bool, name, code| match is_used {
        true => corrected::delay(e, name, cycle_time, code),
        false => Some(0),
    };
    let velocity_delay = delay(additive.any(), Name::VelocityDelayTime, (codes::VELOCITY_DELAY, 70349));
    let acceleration_delay = delay(torque.acceleration, Name::AccelerationDelayTime, (codes::TORQUE_DELAY, 70348));
    let jerk_delay = delay(torque.jerk, Name::JerkDelayTime, (codes::TORQUE_DELAY, 70348));
    let velocity = drive.velocity(e, additive.any())?;
    let torque_scale = if torque.any() { torque_of(e, drive)? } else { None };
    if torque_scale.is_none() {
        torque = Quantities::default();
    }
    Some(Some(Feedforward {
        conventional,
        additive,
        torque,
        default_active: default_active?,
        global_disable: global_disable?,
        weight: weight?,
        acceleration: acceleration?,
        jerk: jerk?,
        velocity_delay: velocity_delay?,
        acceleration_delay: acceleration_delay?,
        jerk_delay: jerk_delay?,
        velocity,
        torque_scale,
    }))
}

/// The destinations of the quantities, as far as the drive has a process datum for them.
fn possible_ways(e: &mut Effective<'_>, words: &[FeedforwardWord], drive: &Drive) -> [Quantities; 3] {
    let [mut conventional, mut additive, mut torque] = ways(words);
    if drive.location == Location::Profidrive && words.contains(&FeedforwardWord::AddVel) {
        // NSOLL_B takes the whole feedforward, not only its velocity.
        additive = Quantities { velocity: true, ..conventional };
        conventional = Quantities::default();
    }
    if additive.any() && drive.velocity.is_none() {
        corrected::no_datum(e, FeedforwardWord::AddVel, Name::AdditiveVelocityData, (codes::NO_VELOCITY_DATA, 70350));
        additive = Quantities::default();
    }
    if torque.any() && drive.torque.is_none() {
        let word = if torque.acceleration { FeedforwardWord::AddAcc } else { FeedforwardWord::AddJerk };
        corrected::no_datum(e, word, Name::AdditiveTorqueData, (codes::NO_TORQUE_DATA, 70351));
        torque = Quantities::default();
    }
    [conventional, additive, torque]
}

/// The weights of the whole, of the acceleration and of the jerk. A quantity with the weight 0 has no destination.
fn weights(e: &mut Effective<'_>, [conventional, additive, torque]: &mut [Quantities; 3]) -> [Option<Ratio>; 3] {
    let weight =
        corrected::ratio(e, [Name::VsVFaktor, Name::VsVNenner], codes::DENOMINATOR, ("feedforward is left out", None));
    let sums = conventional.with(*additive);
    let acceleration = if sums.use_time() || torque.acceleration {
        let weighted = match (torque.acceleration || sums.acceleration, sums.jerk) {
            (true, true) => "the acceleration, and the jerk that shares its time constant, are",
            (false, true) => "the jerk, which has the time constant of the acceleration, is",
            _ => "the acceleration is",
        };
        let consequence = format!("{weighted} left out");
        corrected::ratio(e, [Name::VsAFaktor, Name::VsANenner], codes::DENOMINATOR, (&consequence, None))
    } else {
        Some(Ratio::ZERO)
    };
    let is_out = |ratio: Option<Ratio>| ratio.is_some_and(|ratio| ratio.num == 0);
    if is_out(acceleration) {
        // Without the time constant, the quantities that it weights are dropped too. Inputs that nothing else reads are not
        // validated.
        for sum in [&mut *conventional, &mut *additive] {
            *sum = Quantities { velocity: sum.velocity, ..Quantities::default() };
        }
        torque.acceleration = false;
    }
    if is_out(weight) {
        (*conventional, *additive, *torque) = Default::default();
    }
    let jerk = if conventional.with(*additive).with(*torque).jerk {
        let consequence = ("error 110473 of the controller; it is corrected to 100", Some(100));
        corrected::ratio(e, [Name::JerkFactNum, Name::JerkFactDenom], codes::JERK_FACT, consequence)
    } else {
        Some(Ratio::ZERO)
    };
    if is_out(jerk) {
        for sum in [conventional, additive, torque] {
            sum.jerk = false;
        }
    }
    [weight, acceleration, jerk]
}

/// Each quantity has one destination: conventional, additive velocity or additive torque. An additive output removes it from
/// the position controller.
fn ways(words: &[FeedforwardWord]) -> [Quantities; 3] {
    let has = |word| words.contains(&word);
    let velocity = has(FeedforwardWord::AddVel);
    let [acceleration, jerk] = [FeedforwardWord::AddAcc, FeedforwardWord::AddJerk].map(has);
    let conventional = Quantities {
        velocity: has(FeedforwardWord::Vel) && !velocity,
        acceleration: has(FeedforwardWord::Acc) && !acceleration,
        jerk: has(FeedforwardWord::Jerk) && !jerk,
    };
    let additive = Quantities { velocity, ..Quantities::default() };
    [conventional, additive, Quantities { velocity: false, acceleration, jerk }]
}

/// Rejects ADD_JERK unless it is selected by name.
fn refuse_jerk(e: &mut Effective<'_>, has_jerk: bool) -> Option<()> {
    if !has_jerk || e.word::<AddJerk>(key(Name::AddJerk))? == AddJerk::Experimental {
        return Some(());
    }
    let found = format!("{} has ADD_JERK, whose formula no document gives", e.title(key(Name::FeedforwardMode)));
    e.report.push(
        Diagnostic::error(codes::ADD_JERK, e.place_of(key(Name::FeedforwardMode)), found)
            .allowed("VEL, ACC, JERK, ADD_VEL, ADD_ACC")
            .instead("JERK, or add_jerk = \"experimental\" in a set, to try a formula that is inferred from units"),
    );
    None
}

/// P-AXIS-00566 applies to VEL only (110624).
fn without_delay(e: &mut Effective<'_>, words: &[FeedforwardWord]) -> Option<()> {
    let key = key(Name::FeedforwardWithoutDelay);
    if e.word::<Boolean>(key)? == Boolean::False || words == [FeedforwardWord::Vel] {
        return Some(());
    }
    let words: Vec<&str> = words.iter().map(|word| word.name()).collect();
    let found = format!("{} is TRUE beside {}: error 110624 of the controller", e.title(key), words.join(" "));
    e.report.push(
        Diagnostic::error(codes::WITHOUT_DELAY, e.place_of(key), found)
            .allowed("VEL alone in vorsteuer.vorsteuerung (P-AXIS-00223)")
            .instead("feedforward_without_delay FALSE, or VEL alone"),
    );
    None
}

/// Scaling of the additive torque. Inner `None` if a correction has switched it off.
fn torque_of(e: &mut Effective<'_>, drive: &Drive) -> Option<Option<Torque>> {
    let motor: Option<Motor> = e.word(key(Name::Motor));
    let load = e.real((Name::Load, [drive.gear, 0]));
    let reference = e.real(key(Name::AccReferenceValue));
    let consequence = ("error 110465 of the controller; the additive torque is switched off", None);
    let scale = corrected::ratio(e, [Name::TorqueScaleNum, Name::TorqueScaleDenom], codes::TORQUE_SCALE, consequence);
    let resolution = drive::resolution(e, drive.gear);
    let axis_type: Option<AxisType> = e.word(key(Name::AxisType));
    drive::note(e, &[Name::AdditiveTorqueData]);
    let (motor, load, reference, scale, resolution) = (motor?, load?, reference?, scale?, resolution?);
    if motor == Motor::Linear && axis_type? != AxisType::Translator {
        let found = "`motor` is linear, and the axis turns (P-AXIS-00018)";
        let diagnostic = Diagnostic::error(codes::LINEAR_MOTOR, e.place_of(key(Name::Motor)), found);
        e.report.push(diagnostic.instead("motor = \"rotary\""));
        return None;
    }
    if motor == Motor::Rotary && resolution.incr_per_rev == 0 {
        drive.no_increments(e, "the additive torque needs it");
        return None;
    }
    if reference <= 0.0 {
        let reference_key = key(Name::AccReferenceValue);
        let found = format!("{} is 0: the additive torque is switched off", e.title(reference_key));
        let instead = "the nominal torque of the motor, from its data sheet".to_owned();
        e.warn(codes::NO_REFERENCE, reference_key, found, instead);
        return Some(None);
    }
    // With a factor of 0 the torque is 0: its input is not read either.
    if scale.num == 0 || load <= 0.0 {
        return Some(None);
    }
    let width = drive.torque?;
    Some(Some(Torque { resolution, motor, load, reference, scale, width }))
}
