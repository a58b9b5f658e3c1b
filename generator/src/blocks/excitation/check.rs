//! The rules of the excitation, and whether an axis gets it.

use crate::axis::{Axis, Excitation, Location};
use crate::config::values::key;
use crate::number::{digits, rounded};
use crate::parameters::words::ProcessDatum;
use crate::parameters::{Name, Value};
use crate::{codes, rules::effective::Effective, rules::presence::Presence};
use identification::excitation::{PERIOD, Sequence};

const KEYS: [Name; 4] =
    [Name::ExcitationAmplitude, Name::ExcitationBits, Name::ExcitationClock, Name::ExcitationPeriods];

/// The excitation of one axis; `None` after a reported error.
pub(crate) fn check(e: &mut Effective<'_>, cycle_time_ns: Option<u32>) -> Option<Presence<Excitation>> {
    if KEYS.iter().all(|name| e.given(key(*name)).is_none()) {
        return Some(Presence::Absent);
    }
    let amplitude = e.real(key(Name::ExcitationAmplitude));
    let periods = e.integer(key(Name::ExcitationPeriods));
    let given = |name, e: &mut Effective<'_>| match e.given(key(name)) {
        Some(_) => e.integer(key(name)).map(Some),
        None => Some(None),
    };
    let bits = given(Name::ExcitationBits, e);
    let clock = given(Name::ExcitationClock, e);
    let (amplitude, periods, bits, clock) = (amplitude?, periods?, bits?, clock?);
    let cycle_time = f64::from(cycle_time_ns?) * 1e-9;
    let usual = clock.map_or_else(|| Sequence::for_cycle(cycle_time), |clock| Sequence::with_clock(clock, cycle_time));
    let sequence = bits.map_or(Some(usual), |bits| Sequence::new(bits, usual.clock()))?;
    for (name, value) in [(Name::ExcitationBits, sequence.bits()), (Name::ExcitationClock, sequence.clock())] {
        e.note(key(name), &Value::Integer(i64::from(value)));
    }
    Some(Presence::Present(Excitation { amplitude, sequence, periods }))
}

/// Says what must not be excited, and what would show little.
pub(crate) fn validate(axis: &Axis, e: &mut Effective<'_>) {
    let Some(of) = &axis.excitation else { return };
    let (place, unit) = (key(Name::ExcitationAmplitude), axis.control.velocity_unit());
    let limit = axis.ipc.limit();
    if axis.ipc.is_active() && of.amplitude > limit {
        let found = format!("{} is {}: the limit of v_add is {}", e.title(place), digits(of.amplitude), digits(limit));
        let allowed = format!("at most {} {unit}, P-AXIS-00757 times P-AXIS-00212", digits(limit));
        e.refuse(codes::EXCITES_TOO_MUCH, place, found, [Some(allowed), Some("a smaller excitation.amplitude".into())]);
    }
    no_way_out(axis, e);
    let start = of.at(axis.cycle_time());
    let least = start.least_speed();
    if least + of.amplitude > axis.ipc.v_max {
        let found = format!(
            "the move while exciting needs {} {unit}, with the excitation {}; vb_max is {} (P-AXIS-00212)",
            digits(least),
            digits(least + of.amplitude),
            digits(axis.ipc.v_max)
        );
        e.warn(codes::EXCITES_TOO_FAST, place, found, "a smaller excitation.amplitude".to_owned());
    }
    let period = of.sequence.period() as f64 * axis.cycle_time();
    let names = [Name::ExcitationBits, Name::ExcitationClock];
    let place = names.into_iter().map(key).find(|key| e.given(*key).is_some()).unwrap_or(place);
    let lasts = format!(
        "a period of the excitation, (2^{} - 1) * {} cycles, lasts {} s",
        of.sequence.bits(),
        of.sequence.clock(),
        rounded(period)
    );
    if of.sequence.period() < start.fade() {
        let found = format!("{lasts}; the excitation rises in 0.1 s");
        let instead = "more excitation.bits, or a longer excitation.clock".to_owned();
        e.refuse(codes::EXCITES_TOO_BRIEFLY, place, found, [Some("at least 0.1 s".to_owned()), Some(instead)]);
    } else if period < PERIOD {
        let found = format!("{lasts}: its lines are {} Hz apart", rounded(of.sequence.spacing(axis.cycle_time())));
        let instead = "more excitation.bits, for 4 s or more, or neither bits nor clock".to_owned();
        e.warn(codes::EXCITES_COARSELY, place, found, instead);
    }
}

/// Warns of an excitation that no process datum takes to a drive that controls the position.
fn no_way_out(axis: &Axis, e: &mut Effective<'_>) {
    let in_drive = axis.control.position_control.as_ref().is_some_and(|of| of.location != Location::Cnc);
    if in_drive && e.validated_word(key(Name::AdditiveVelocityData)) == Some(ProcessDatum::None) {
        let found =
            "the drive controls the position, and its process data have no additive velocity: v_excite cannot reach it";
        let instead = "process_data.additive_velocity = \"INT32\" in a set, if the drive has it".to_owned();
        e.warn(codes::NO_WAY_FOR_EXCITATION, key(Name::ExcitationAmplitude), found, instead);
    }
}
