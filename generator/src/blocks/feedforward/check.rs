//! The rules of feedforward: the available quantities, their destinations, and corrections.

use crate::axis::{Feedforward, Location, Quantities, Ratio, Torque};
use crate::parameters::words::{AddJerk, AxisType, Boolean, FeedforwardWord, Motor, Words};
use crate::parameters::{Name, Value};
use crate::rules::drive::{self, Drive};
use crate::rules::{corrected, effective::Effective, presence::Presence};
use crate::{codes, config::values::key, diagnostics::Diagnostic};

/// Feedforward of one axis; `None` after a reported error.
pub(crate) fn check(e: &mut Effective<'_>, cycle_time: Option<u32>, drive: &Drive) -> Option<Presence<Feedforward>> {
    let words: Vec<FeedforwardWord> = e.validated_words(key(Name::FeedforwardMode))?;
    let has = |word| words.contains(&word);
    if has(FeedforwardWord::None) || words.is_empty() {
        return Some(Presence::Absent);
    }
    e.note(key(Name::FeedforwardMode), &Value::Words(words.iter().map(|word| word.name()).collect()));
    drive::note(e, &[Name::DriveType, Name::OperationMode]);
    let has_allowed_jerk = refuse_jerk(e, has(FeedforwardWord::AddJerk));
    let mut ways = possible_ways(e, &words, drive);
    let has_allowed_delay = without_delay(e, &words);
    let [default_active, global_disable] = [Name::DefaultActive, Name::GlobalDisable]
        .map(|name| e.word::<Boolean>(key(name)).map(|word| word == Boolean::True));
    let [weight, acceleration, jerk] = weights(e, &mut ways);
    let Ways { conventional, additive, torque } = ways;
    let [velocity_delay, acceleration_delay, jerk_delay] = delays(e, cycle_time, ways);
    let velocity = drive.velocity(e, additive.any());
    let torque_scale = if torque.any() { torque_of(e, drive)?.present() } else { None };
    has_allowed_jerk.and(has_allowed_delay)?;
    let torque = if torque_scale.is_some() { torque } else { Quantities::default() };
    Some(Presence::Present(Feedforward {
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
        velocity: velocity?.present(),
        torque_scale,
    }))
}

/// The quantities that go each way.
#[derive(Clone, Copy, Default)]
struct Ways {
    /// to the position controller
    conventional: Quantities,
    /// to the drive, as an additive velocity
    additive: Quantities,
    /// to the drive, as an additive torque
    torque: Quantities,
}

impl Ways {
    /// The quantities that go to the position controller or are added to the velocity.
    fn sums(self) -> Quantities {
        self.conventional.with(self.additive)
    }
}

/// The ways of the quantities that the drive has a datum for.
fn possible_ways(e: &mut Effective<'_>, words: &[FeedforwardWord], drive: &Drive) -> Ways {
    let Ways { mut conventional, mut additive, mut torque } = ways(words);
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
    Ways { conventional, additive, torque }
}

/// The weights of all, of the acceleration and of the jerk; what a weight of 0 leaves out goes no way.
fn weights(e: &mut Effective<'_>, ways: &mut Ways) -> [Option<Ratio>; 3] {
    let weight =
        corrected::ratio(e, [Name::VsVFaktor, Name::VsVNenner], codes::DENOMINATOR, ("feedforward is left out", None));
    // Before a weight of 0 empties the ways: the parameters of the acceleration are validated all the same.
    let acceleration = weight_of_acceleration(e, ways);
    if is_out(weight) {
        *ways = Ways::default();
    }
    [weight, acceleration, weight_of_jerk(e, ways)]
}

fn is_out(weight: Option<Ratio>) -> bool {
    weight.is_some_and(|weight| weight.num == 0)
}

/// The weight of the acceleration, and of the jerk where it has the same time constant.
fn weight_of_acceleration(e: &mut Effective<'_>, ways: &mut Ways) -> Option<Ratio> {
    let sums = ways.sums();
    if !sums.use_time() && !ways.torque.acceleration {
        return Some(Ratio::ZERO);
    }
    let weighted = match (ways.torque.acceleration || sums.acceleration, sums.jerk) {
        (true, true) => "the acceleration, and the jerk that shares its time constant, are",
        (false, true) => "the jerk, which has the time constant of the acceleration, is",
        _ => "the acceleration is",
    };
    let consequence = format!("{weighted} left out");
    let weight = corrected::ratio(e, [Name::VsAFaktor, Name::VsANenner], codes::DENOMINATOR, (&consequence, None));
    if is_out(weight) {
        // With the time constant goes all that it weights; inputs that nothing else reads are not validated either.
        for sum in [&mut ways.conventional, &mut ways.additive] {
            *sum = Quantities { velocity: sum.velocity, ..Quantities::default() };
        }
        ways.torque.acceleration = false;
    }
    weight
}

fn weight_of_jerk(e: &mut Effective<'_>, ways: &mut Ways) -> Option<Ratio> {
    if !ways.sums().with(ways.torque).jerk {
        return Some(Ratio::ZERO);
    }
    let consequence = ("error 110473 of the controller; it is corrected to 100", Some(100));
    let weight = corrected::ratio(e, [Name::JerkFactNum, Name::JerkFactDenom], codes::JERK_FACT, consequence);
    if is_out(weight) {
        for way in [&mut ways.conventional, &mut ways.additive, &mut ways.torque] {
            way.jerk = false;
        }
    }
    weight
}

/// Delays of the additive velocity, of the torque of the acceleration and of that of the jerk; 0 for an unused output.
fn delays(e: &mut Effective<'_>, cycle_time: Option<u32>, Ways { additive, torque, .. }: Ways) -> [Option<u32>; 3] {
    let of_torque = (codes::TORQUE_DELAY, 70348);
    let delays = [
        (additive.any(), Name::VelocityDelayTime, (codes::VELOCITY_DELAY, 70349)),
        (torque.acceleration, Name::AccelerationDelayTime, of_torque),
        (torque.jerk, Name::JerkDelayTime, of_torque),
    ];
    delays.map(|(is_used, name, code)| if is_used { corrected::delay(e, name, cycle_time, code) } else { Some(0) })
}

/// Each quantity goes one way, conventional or as additive velocity or torque: an additive output takes it away from the
/// position controller.
fn ways(words: &[FeedforwardWord]) -> Ways {
    let has = |word| words.contains(&word);
    let velocity = has(FeedforwardWord::AddVel);
    let [acceleration, jerk] = [FeedforwardWord::AddAcc, FeedforwardWord::AddJerk].map(has);
    let conventional = Quantities {
        velocity: has(FeedforwardWord::Vel) && !velocity,
        acceleration: has(FeedforwardWord::Acc) && !acceleration,
        jerk: has(FeedforwardWord::Jerk) && !jerk,
    };
    let additive = Quantities { velocity, ..Quantities::default() };
    Ways { conventional, additive, torque: Quantities { velocity: false, acceleration, jerk } }
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
    let found = format!("{} is TRUE together with {}: error 110624 of the controller", e.title(key), words.join(" "));
    e.report.push(
        Diagnostic::error(codes::WITHOUT_DELAY, e.place_of(key), found)
            .allowed("VEL alone in vorsteuer.vorsteuerung (P-AXIS-00223)")
            .instead("feedforward_without_delay FALSE, or VEL alone"),
    );
    None
}

/// Scaling of the additive torque; absent: a correction has switched it off; `None` after a reported error.
fn torque_of(e: &mut Effective<'_>, drive: &Drive) -> Option<Presence<Torque>> {
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
        return Some(Presence::Absent);
    }
    // With a factor of 0 the torque is 0: its input is not read either.
    if scale.num == 0 || load <= 0.0 {
        return Some(Presence::Absent);
    }
    let width = drive.torque?;
    Some(Presence::Present(Torque { resolution, motor, load, reference, scale, width }))
}
