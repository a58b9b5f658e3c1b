//! Warnings about a valid axis: what is legal, but without effect, out of date or dangerous. The only error here is a loop
//! that cannot be stable.

use super::check::master;
use super::{filter as kinds, never_acts, phase, set_point, stage::StageDesign, unstable};
use crate::axis::{Axis, Ipc, Mode, Stage};
use crate::config::values::{Key, Setting, key};
use crate::parameters::words::{Enable, FilterType, StageMode, Words};
use crate::parameters::{FILTERS, Name, STAGES, Value, path_with, real_text};
use crate::rules::effective::{Effective, as_written};
use crate::{
    blocks::designed::Designed,
    codes,
    diagnostics::Diagnostic,
    number::{digits, rounded},
};
use portable::Extreme;

/// Above this f0 * Ts the upper skirt of a band-pass is compressed towards half the sampling frequency.
const NEAR_NYQUIST: f64 = 0.35;
/// Below this f0 [Hz] the fade takes more than 2 s.
const LOW_F0: f64 = 0.5;
/// Twice the weight at which the controller caps: with a usual damping ratio no weight reaches this gain.
const MUCH_GAIN: f64 = 2.0 * Stage::MAX_WEIGHT;
/// Few axes have a largest velocity below 5 mm/s or 5 deg/s; a value below it is probably in mm/s, m/min, deg/s or
/// revolutions/min.
const SLOW: f64 = 5000.0;
/// 10 rpm: every spindle is faster, and most are faster than 10000 thousandths of a degree per second.
const SLOW_SPINDLE: f64 = 60_000.0;
/// 10 m/s: few linear axes are faster; a value above it is probably in um/min or nm/s.
const FAST: f64 = 1e7;

/// Warns of what a user should know before the block acts.
pub(crate) fn advise(designed: &Designed, gear: u32, e: &mut Effective<'_>) {
    let axis = &designed.axis;
    whole(axis, e);
    for (i, design) in (0..STAGES).zip(&designed.stage) {
        inert_source(e, i, design.as_ref());
        if let Some(design) = design {
            damping_generations(e, i, &design.stage);
            filter_without_type(e, i, &design.stage);
            capped(e, i, &design.stage);
            no_denominator(e, i, &design.stage);
            resonance(e, i, &design.stage);
            frequencies(e, i, &design.stage, axis.cycle_time_ns);
            phase::advise(e, i, design, &axis.ipc);
        }
    }
    overlaps(designed, e);
    never_acts::advise(axis, e);
    let oscillates = unstable::advise(designed, gear, e);
    set_point::advise(designed, oscillates, e);
}

fn whole(axis: &Axis, e: &mut Effective<'_>) {
    let (ipc, is_active) = (&axis.ipc, axis.ipc.is_active());
    let slave = master(e).is_some();
    if is_active || axis.control.position_control.is_some() {
        unit_of_vb_max(axis, e);
    }
    if is_active && !slave && ipc.enable == Enable::On && ipc.v_add_max_fact >= Ipc::WHOLE {
        starts_on(axis, e);
    }
    if slave && is_active && ipc.enable == Enable::Off {
        let found = "the axis is a gantry slave with active stages: its input `mode` must stay OFF (error 70600)";
        let instead = Some("the stages in the list of the master".to_owned());
        e.warn(codes::SLAVE_STAGES, key(Name::GantryMaster), found, instead);
    }
    if !is_active && !slave && (axis.asks_for_nothing_else() || ipc.enable != Enable::Off) {
        no_stage(axis, e);
    }
    if is_active && ipc.v_add_max_fact == 0 {
        let how = if e.given(key(Name::VAddMaxFact)).is_some() { "is" } else { "has the default" };
        let path = Name::VAddMaxFact.parameter().path;
        let found = format!("`{path}` (P-AXIS-00757) {how} 0: the limit is 0, the block puts out 0");
        e.warn(codes::MUTED, key(Name::VAddMaxFact), found, Some("a limit above 0, in 0.1 % of vb_max".to_owned()));
    }
}

/// Warns of a block that starts ON with the whole of vb_max.
fn starts_on(axis: &Axis, e: &mut Effective<'_>) {
    let key = key(Name::Enable);
    let found = format!(
        "the block starts ON (P-AXIS-00758), and v_add may reach {} {}: {} % of vb_max (P-AXIS-00757)",
        axis.ipc.limit(),
        axis.control.velocity_unit(),
        f64::from(axis.ipc.v_add_max_fact) / 10.0
    );
    let dry_run = as_written(&e.place_of(key), key, &[Enable::DryRun.name()]);
    let instead = format!("{dry_run} for the first look, then ON with a small v_add_max_fact");
    e.warn(codes::STARTS_ON, key, found, Some(instead));
}

/// Warns that the block adds nothing.
fn no_stage(axis: &Axis, e: &mut Effective<'_>) {
    let enable = axis.ipc.enable.name();
    let found = match axis.asks_for_nothing_else() {
        true => "no stage is active: the block puts out 0".to_owned(),
        false => format!("improved position control is {enable}, and no stage is active: it adds nothing"),
    };
    let is_about_it = |name: Name| name.parameter().path.contains("improved_position_control");
    let place = e.place_near(key(Name::Enable), is_about_it);
    let [direct, indirect, set_point] = [StageMode::Direct, StageMode::Indirect, StageMode::SetPoint].map(Words::name);
    let path = path_with(Name::Mode.parameter().path, [0, 0]);
    let instead = format!("{path} with {direct}, {indirect} or {set_point}");
    e.report.push(Diagnostic::warning(codes::NO_STAGE, place, found).instead(instead));
}

/// Warns of a largest velocity that is probably in another unit.
fn unit_of_vb_max(axis: &Axis, e: &mut Effective<'_>) {
    let key = (Name::VbMax, [e.validated_integer(key(Name::Gear)).unwrap_or(0), 0]);
    let v_max = axis.ipc.v_max;
    let slow = if axis.control.is_spindle { SLOW_SPINDLE } else { SLOW };
    if e.given(key).is_none() {
        return;
    }
    if v_max > FAST && !axis.control.is_rotary {
        let found = format!("{} is {v_max}, which is {} m/s", e.title(key), rounded(v_max / 1e6));
        let [of_minute, of_nm] = [60.0, 1e3].map(|factor| libm::round(v_max / factor));
        let instead =
            format!("{of_minute}, if {v_max} um/min is meant, or {of_nm}, if {v_max} nm/s is meant: the unit is um/s");
        return e.warn(codes::SLOW, key, found, Some(instead));
    }
    if v_max >= slow {
        return;
    }
    let (unit, per_second, per_minute, factor) = match axis.control.is_rotary {
        true => ("0.001 deg/s", "deg/s", "revolutions/min", 6e3),
        false => ("um/s", "mm/s", "m/min", 1e6 / 60.0),
    };
    let found = format!("{} is {v_max}, which is only {} {per_second}", e.title(key), v_max / 1e3);
    let (of_second, of_minute) = (v_max * 1e3, libm::round(v_max * factor));
    let instead = format!(
        "{of_second}, if {v_max} {per_second} is meant, or {of_minute}, if {v_max} {per_minute} is meant: the unit is {unit}"
    );
    e.warn(codes::SLOW, key, found, Some(instead));
}

/// Warns of P-AXIS-00756 together with parameters that were introduced with its successor.
fn damping_generations(e: &mut Effective<'_>, i: u32, stage: &Stage) {
    let old_key = (Name::FilterDamping, [i, 0]);
    let uses_damping = stage.mode.osc_damping().is_some();
    let is_set = |setting: &Setting| matches!(setting.value, Some(Value::Real(x)) if x > 0.0);
    if !uses_damping || !e.given(old_key).is_some_and(is_set) {
        return;
    }
    let is_new = |(name, [stage, _]): Key, setting: &Setting| {
        let path = name.parameter().path;
        let of_filter = path.contains("filter[k]") && setting.spelling == path;
        stage == i && (of_filter || name == Name::OscDamping && is_set(setting))
    };
    let newer = e.all_given().find(|(key, setting)| is_new(*key, setting));
    if let Some(((_, index), setting)) = newer {
        let newer = path_with(setting.spelling, index);
        let found = format!(
            "stage[{i}].filter.damping (P-AXIS-00756) is given together with `{newer}` of the newer parameters"
        );
        let instead = format!("{} (P-AXIS-00850) alone", path_with(Name::OscDamping.parameter().path, [i, 0]));
        e.warn(codes::GENERATIONS, old_key, found, Some(instead));
    }
}

/// Warns of a filter that is described but has no type.
fn filter_without_type(e: &mut Effective<'_>, i: u32, stage: &Stage) {
    for k in (0..FILTERS).filter(|k| stage.filter[*k as usize].kind() == FilterType::NoFilter) {
        let described = [Name::FilterOrder, Name::FilterF0, Name::FilterQ, Name::FilterPrototype]
            .into_iter()
            .find(|name| e.given((*name, [i, k])).is_some());
        let typed = e.given((Name::FilterType, [i, k])).is_some();
        if let Some(name) = described.filter(|_| !typed) {
            let found = format!("stage[{i}].filter[{k}] has parameters and no type: it is NO_FILTER (P-AXIS-00849)");
            let types = FilterType::ALL.iter().filter(|ty| **ty != FilterType::NoFilter);
            let words: Vec<_> = types.map(|ty| ty.name()).collect();
            let instead = as_written(&e.place_of((name, [i, k])), (Name::FilterType, [i, k]), &words);
            e.warn(codes::NO_TYPE, (name, [i, k]), found, Some(instead));
        }
    }
}

/// The controller caps a large weight without a message.
fn capped(e: &mut Effective<'_>, i: u32, stage: &Stage) {
    if !stage.cap().is_empty() {
        let (num, denom, asked) = (stage.weight_fact_num, stage.weight_fact_denom, digits(stage.asked_weight()));
        let found =
            format!("stage[{i}] asks for the weight {num}/{denom} = {asked}: it is capped at {}", Stage::MAX_WEIGHT);
        let instead = format!(
            "weight_fact_num / weight_fact_denom <= {}; without a line weight_fact_denom (P-AXIS-00755) is 1",
            Stage::MAX_WEIGHT
        );
        e.warn(codes::CAPPED, (Name::WeightFactNum, [i, 0]), found, Some(instead));
    }
}

/// Warns of a numerator without a denominator, which is probably a percentage.
fn no_denominator(e: &mut Effective<'_>, i: u32, stage: &Stage) {
    let [num, denom] = [Name::WeightFactNum, Name::WeightFactDenom].map(|name| (name, [i, 0]));
    let is_alone = e.given(num).is_some() && e.given(denom).is_none();
    if is_alone && stage.weight_fact_num > 1 && stage.cap().is_empty() {
        let number = stage.weight_fact_num;
        let found =
            format!("{} is {number}, and without weight_fact_denom the weight is {number}: {number}00 %", e.title(num));
        let path = path_with(denom.0.parameter().path, denom.1);
        let instead = format!("{path} (P-AXIS-00755) with 100, if {number} % is meant, or with 1");
        e.warn(codes::NO_DENOMINATOR, num, found, instead);
    }
}

/// The gain of the simulated oscillation multiplies the weight, which is capped for a reason: |H(f0)| = sqrt(1 + 1 / (4
/// D^2)).
fn resonance(e: &mut Effective<'_>, i: u32, stage: &Stage) {
    let Mode::Indirect { osc_damping } = stage.mode else { return };
    let peak = libm::sqrt(1.0 + 0.25 / (osc_damping * osc_damping));
    let gain = stage.weight() * peak;
    if gain > MUCH_GAIN {
        let found = format!(
            "stage[{i}] is INDIRECT with the damping ratio {}: its simulated oscillation has {} times the motor's velocity at f0, \
             with the weight {} {} times",
            real_text(osc_damping),
            rounded(peak),
            rounded(stage.weight()),
            rounded(gain)
        );
        let instead = Some("a larger damping ratio or a smaller weight, and DRYRUN first".to_owned());
        e.warn(codes::RESONANCE, e.source((Name::OscDamping, [i, 0])), found, instead);
    }
}

/// Warns of a source that no stage uses.
fn inert_source(e: &mut Effective<'_>, i: u32, design: Option<&StageDesign>) {
    let key = (Name::DirectSource, [i, 0]);
    let is_direct = design.is_some_and(|design| matches!(design.stage.mode, Mode::Direct { .. }));
    if !is_direct && e.given(key).is_some() {
        let found = format!("stage[{i}].direct_source has no effect: the stage is not DIRECT");
        e.warn(codes::INERT, key, found, None);
    }
}

/// Warns of a centre frequency that is probably in kHz, and of one near half the sampling frequency.
fn frequencies(e: &mut Effective<'_>, i: u32, stage: &Stage, cycle_time_ns: u32) {
    for (k, filter) in (0..FILTERS).zip(&stage.filter) {
        let Some(f0) = filter.f0() else { continue };
        let key = (Name::FilterF0, [i, k]);
        if f0 < LOW_F0 {
            let (written, period) = (real_text(f0), rounded(1.0 / f0));
            let title = e.title(key);
            let found =
                format!("{title} is {written} Hz: the fade lasts at least one period of it, {period} s, also to OFF");
            let instead = format!("{}, if {written} kHz is meant: the unit is Hz", rounded(f0 * 1e3));
            e.warn(codes::LOW_F0, key, found, instead);
        }
        let f0_ts = f0 * f64::from(cycle_time_ns) / 1e9;
        if f0_ts > NEAR_NYQUIST {
            let Some(what) = kinds::of(filter).map(|kind| kind.squeezed()) else { continue };
            let found = format!(
                "stage[{i}].filter[{k}] lies at {} of the sampling frequency: its {what} is squeezed against one half",
                rounded(f0_ts)
            );
            let instead =
                Some(format!("a shorter cycle time, or fg_f0 below {NEAR_NYQUIST} of the sampling frequency"));
            e.warn(codes::SQUEEZED, key, found, instead);
        }
    }
}

/// Warns of stages with overlapping bands: they influence each other.
fn overlaps(designed: &Designed, e: &mut Effective<'_>) {
    let bands: Vec<_> = (0..).zip(&designed.stage).filter_map(|(j, stage)| Some((j, stage.as_ref()?))).collect();
    for (n, (i, stage)) in bands.iter().enumerate() {
        for (j, other) in &bands[n + 1..] {
            let [[low, high], [other_low, other_high]] = [stage, other].map(|design| band_of(design));
            if low.larger(other_low) < high.smaller(other_high) {
                let found = format!(
                    "stage[{i}] ({} to {} Hz) and stage[{j}] ({} to {} Hz) overlap, and influence each other",
                    rounded(low),
                    rounded(high),
                    rounded(other_low),
                    rounded(other_high)
                );
                let key = (Name::FilterF0, [*j, other.stage.first_bandpass()]);
                e.warn(codes::OVERLAP, key, found, Some("a higher q_factor, or other frequencies".to_owned()));
            }
        }
    }
}

/// The band in which all band-passes of a stage lose at most 3 dB, in Hz.
pub(super) fn band_of(design: &StageDesign) -> [f64; 2] {
    let filters = design.filter.iter().flatten().filter(|of| kinds::is_selective(&of.filter));
    filters.fold([0.0, f64::INFINITY], |[low, high], of| [of.edges[0].larger(low), of.edges[1].smaller(high)])
}
