//! The rules of improved position control whose violation is an error: such a block must not act on a machine.

use super::filter;
use crate::axis::{Filter, Ipc, Mode, Numbers, Stage, Tuning};
use crate::parameters::words::{Boolean, Enable, FilterType, StageMode, Tunable, Words};
use crate::parameters::{Name, Value, path_with, real_text, time_text};
use crate::rules::effective::{Effective, as_written};
use crate::rules::presence::Presence;
use crate::{codes, config::values::key};
use portable::{Real, RealKind};
use reference::signal::sample_limit;

/// Improved position control of one axis; `None` after a reported error.
pub(crate) fn check(e: &mut Effective<'_>, cycle_time: Option<u32>, real: Option<RealKind>) -> Option<Ipc> {
    let enable = e.word(key(Name::Enable));
    gantry(e, enable);
    let v_add_max_fact = e.integer(key(Name::VAddMaxFact));
    let v_max = v_max(e, real);
    let fade = e.duration(key(Name::Fade));
    let ride_through = e.integer(key(Name::RideThrough));
    let numbers = numbers(e);
    let watch = watch(e);
    // Every stage is checked, so that the errors of all stages are reported.
    let stages = [0, 1, 2].map(|i| stage(e, i, cycle_time));
    let is_active = stages.iter().any(|stage| !matches!(stage, Some(Presence::Absent)));
    let delay_cycles = if is_active { delay_cycles(e) } else { None };
    let [first, second, third] = stages;
    let fade = fade? as f64 / 1e9;
    let stage = [first?, second?, third?].map(Presence::present);
    // What never acts needs no sets.
    let needs_sets = is_active && master(e).is_none();
    let takes_sets = |numbers: &Numbers| matches!(numbers, Numbers::Sets { .. });
    let numbers = numbers.map(|numbers| if takes_sets(&numbers) && !needs_sets { Numbers::Fixed } else { numbers });
    let (v_add_max_fact, v_max, ride_through) = (v_add_max_fact?, v_max?, ride_through?);
    let ipc = Ipc {
        enable: enable?,
        v_add_max_fact,
        v_max,
        fade,
        ride_through,
        numbers: numbers?,
        watch: watch?,
        delay_cycles,
        stage,
    };
    above_lowest(e, &ipc)?;
    fade_cycles(e, &ipc, cycle_time)?;
    Some(ipc)
}

/// The source of the numbers; `None` after a reported error.
fn numbers(e: &mut Effective<'_>) -> Option<Numbers> {
    match e.word::<Tunable>(key(Name::Tunable))? {
        Tunable::Nothing => Some(Numbers::Fixed),
        Tunable::All => Some(Numbers::Sets { lowest_f0: None }),
        Tunable::Parameters => Some(Numbers::Sets { lowest_f0: Some(lowest_f0(e)?) }),
        Tunable::Weights => {
            let limit = e.real(key(Name::TuningLimit));
            let [first, second, third] = [0, 1, 2].map(|i| e.real((Name::TuningWeight, [i, 0])));
            Some(Numbers::Weights(Tuning { limit: limit?, weight: [first?, second?, third?] }))
        }
    }
}

/// The lowest centre frequency that the controller may design. It is never taken from the filters: then a set with other
/// frequencies would have another structure.
fn lowest_f0(e: &mut Effective<'_>) -> Option<f64> {
    let (key, of) = (key(Name::LowestF0), key(Name::Tunable));
    if e.given(key).is_some() {
        return e.real(key);
    }
    let found = "`tunable` is \"parameters\", and `lowest_f0` is missing".to_owned();
    let allowed = "the lowest f0 that anybody may type [Hz]: the fade lasts at least one period of it".to_owned();
    e.refuse(codes::LOWEST_F0, of, found, [Some(allowed), Some("lowest_f0 = 10".to_owned())]);
    None
}

/// No filter may be below the lowest centre frequency.
fn above_lowest(e: &mut Effective<'_>, ipc: &Ipc) -> Option<()> {
    let (Some(least), Some(place)) = (ipc.lowest_f0(), lowest(ipc)) else { return Some(()) };
    let f0 = e.real(place)?;
    if f0 >= least {
        return Some(());
    }
    let found = format!("{} is {} Hz, and `lowest_f0` is {} Hz", e.title(place), real_text(f0), real_text(least));
    let instead = format!("lowest_f0 = {}", real_text(f0));
    let allowed = "every f0 of the set at lowest_f0 or above".to_owned();
    e.refuse(codes::LOWEST_F0, place, found, [Some(allowed), Some(instead)]);
    None
}

/// Whether the loop is watched. The digest of the parameters covers the key only if it is, so that other blocks keep their
/// digest.
fn watch(e: &mut Effective<'_>) -> Option<bool> {
    let is_watched = e.validated_word::<Boolean>(key(Name::Watch))? == Boolean::True;
    if is_watched {
        e.word::<Boolean>(key(Name::Watch))?;
    }
    Some(is_watched)
}

/// Cycles between a command and the actual value that it caused (P-AXIS-00191), if given. They determine the phase lag of a
/// loop; no block depends on them.
fn delay_cycles(e: &mut Effective<'_>) -> Option<u32> {
    let key = key(Name::NbrDelayCycles);
    e.given(key)?;
    e.validated_integer(key)
}

/// A gantry slave gets the master's additive velocity: it must not have its own (70600).
fn gantry(e: &mut Effective<'_>, enable: Option<Enable>) {
    if master(e).is_none() || enable.is_none_or(|enable| enable == Enable::Off) {
        return;
    }
    let master = e.given(key(Name::GantryMaster)).and_then(|setting| setting.value.as_ref());
    let master = master.map(Value::text).unwrap_or_default();
    let found = format!(
        "improved position control is enabled on a gantry slave, whose master is axis {master} (P-AXIS-00070): error \
         70600 of the controller"
    );
    let key = key(Name::Enable);
    let off = as_written(&e.place_of(key), key, &[Enable::Off.name()]);
    let instead = format!("{off} here, and the stages in the list of axis {master}");
    e.refuse(codes::GANTRY_SLAVE, key, found, [None, Some(instead)]);
}

/// The logical number of the master, if this axis is a gantry slave.
pub(crate) fn master(e: &mut Effective<'_>) -> Option<u32> {
    let own = e.validated_integer(key(Name::AxisNumber));
    e.validated_integer(key(Name::GantryMaster)).filter(|master| *master > 0 && own != Some(*master))
}

/// The largest velocity, of the gear step in use. The block must accept it, and twice it, as a sample in range.
fn v_max(e: &mut Effective<'_>, real: Option<RealKind>) -> Option<f64> {
    let key = (Name::VbMax, [e.validated_integer(key(Name::Gear))?, 0]);
    let v_max = e.integer(key).map(f64::from)?;
    let largest = sample_limit::<f32>().to_f64() / 2.0;
    if real? == RealKind::F32 && v_max > largest {
        let found = format!(
            "`{}` (P-AXIS-00212) is {v_max}: in single precision the block takes more than {} for a bad sample",
            path_with(key.0.parameter().path, key.1),
            2.0 * largest
        );
        let allowed = format!("vb_max <= {largest} in single precision");
        e.refuse(codes::TOO_FAST, key, found, [Some(allowed), Some("real = \"f64\" for this axis".to_owned())]);
        return None;
    }
    Some(v_max)
}

/// A stage; absent: it is not active; `None` after a reported error.
fn stage(e: &mut Effective<'_>, i: u32, cycle_time: Option<u32>) -> Option<Presence<Stage>> {
    let word: StageMode = e.deciding_word((Name::Mode, [i, 0]))?;
    let mode = match word {
        StageMode::NotActive => return Some(Presence::Absent),
        StageMode::Direct => e.word((Name::DirectSource, [i, 0])).map(|source| Mode::Direct { source }),
        StageMode::Indirect => osc_damping(e, i).map(|osc_damping| Mode::Indirect { osc_damping }),
        StageMode::SetPoint => osc_damping(e, i).map(|osc_damping| Mode::SetPoint { osc_damping }),
    };
    let weight_fact_num = e.integer((Name::WeightFactNum, [i, 0]));
    let weight_fact_denom = e.integer((Name::WeightFactDenom, [i, 0]));
    let [first, second] = [0, 1].map(|k| filter::read(e, [i, k], cycle_time));
    let filter = [first?, second?];
    if !filter.iter().any(filter::is_selective) {
        let key = (Name::FilterType, [i, 0]);
        let found = format!("stage[{i}] is {} and has no band-pass", word.name());
        let allowed = "at least one BANDPASS in every active stage (P-AXIS-00849)".to_owned();
        let instead = as_written(&e.place_of(key), key, &[FilterType::Bandpass.name()]);
        e.refuse(codes::NO_BANDPASS, key, found, [Some(allowed), Some(instead)]);
        return None;
    }
    Some(Presence::Present(Stage {
        mode: mode?,
        weight_fact_num: weight_fact_num?,
        weight_fact_denom: weight_fact_denom?,
        filter,
    }))
}

/// Damping ratio from P-AXIS-00850 or its predecessor P-AXIS-00756; an error if they have different values.
fn osc_damping(e: &mut Effective<'_>, i: u32) -> Option<f64> {
    let keys = [(Name::OscDamping, [i, 0]), (Name::FilterDamping, [i, 0])];
    let given = keys.map(|key| e.given(key));
    if given.into_iter().flatten().any(|setting| setting.value.is_none()) {
        return None;
    }
    let [new, old] = given.map(|setting| match setting?.value {
        Some(Value::Real(x)) if x > 0.0 => Some(x),
        _ => None,
    });
    if let (Some(new), Some(old)) = (new, old)
        && new.to_bits() != old.to_bits()
    {
        let parameter = Name::OscDamping.parameter();
        let [title, old_title] = [parameter.title(parameter.path, keys[0].1), e.title(keys[1])];
        let found = format!("{title} is {}, and its predecessor {old_title} is {}", real_text(new), real_text(old));
        let [allowed, instead] = ["one of the two, or equal values", "only P-AXIS-00850"].map(str::to_owned);
        e.refuse(codes::DAMPING, keys[0], found, [Some(allowed), Some(instead)]);
        return None;
    }
    // A value that was given is checked: if neither can be read, the newer one.
    let is_old = new.is_none() && (old.is_some() || given[0].is_none() && given[1].is_some());
    let value = e.validated(keys[usize::from(is_old)])?;
    // The block does not depend on which of the two parameters the value came from.
    e.note(keys[0], &value);
    if let Value::Real(damping) = value { Some(damping) } else { None }
}

/// The fade is counted in cycles, which must be exact in single precision.
fn fade_cycles(e: &mut Effective<'_>, ipc: &Ipc, cycle_time: Option<u32>) -> Option<()> {
    let ns = cycle_time?;
    let cycles = ipc.fade_time() * 1e9 / f64::from(ns);
    if cycles <= Ipc::MAX_FADE_CYCLES {
        return Some(());
    }
    let longest = Ipc::MAX_FADE_CYCLES * f64::from(ns) / 1e9;
    let time = time_text(u64::from(ns));
    if ipc.fade_time() > ipc.fade {
        let designs = ipc.lowest_f0().is_some();
        let (key, name) = if designs { (key(Name::LowestF0), "lowest_f0") } else { (lowest(ipc)?, "fg_f0") };
        let f0 = e.real(key)?;
        let found = format!("{} is {} Hz: the fade lasts at least one period of it", e.title(key), real_text(f0));
        let least = (1e6 / longest).ceil() / 1e6;
        let allowed = format!("{name} >= {least} Hz at a cycle time of {time}: {} cycles", Ipc::MAX_FADE_CYCLES);
        e.refuse(codes::FADE, key, found, [Some(allowed), Some("a longer cycle time".to_owned())]);
        return None;
    }
    let key = key(Name::Fade);
    let found = format!("`fade` is {} s, {} cycles", real_text(ipc.fade), cycles.ceil());
    let allowed = format!("{} cycles: {} s at a cycle time of {time}", Ipc::MAX_FADE_CYCLES, real_text(longest));
    let instead = format!("fade = \"{}s\" at the most, or a longer cycle time", real_text(longest));
    e.refuse(codes::FADE, key, found, [Some(allowed), Some(instead)]);
    None
}

/// The parameter of the lowest frequency of all filters.
fn lowest(ipc: &Ipc) -> Option<(Name, [u32; 2])> {
    let of_stage = |(i, stage): (u32, &Option<Stage>)| {
        let filters = stage.as_ref().map(|stage| stage.filter).into_iter().flatten();
        let place = |(k, filter): (u32, Filter)| Some((filter.f0()?, (Name::FilterF0, [i, k])));
        (0..).zip(filters).filter_map(place).collect::<Vec<_>>()
    };
    let places = (0..).zip(&ipc.stage).flat_map(of_stage);
    places.min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, place)| place)
}
