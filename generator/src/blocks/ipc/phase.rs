//! Warnings about a valid axis: the influences on the phase of a stage, which are the delay of its loop, the load and an
//! all-pass.

use super::closed_loop::looks_at_load;
use super::filter as kinds;
use super::filter::FilterDesign;
use super::stage::StageDesign;
use crate::axis::{Enable, Ipc, Mode, Stage};
use crate::design::band::warped;
use crate::parameters::words::FilterType;
use crate::parameters::{FILTERS, Name, real_text};
use crate::{codes, number::rounded, rules::effective::Effective};

/// A loop through the measured velocity has a transport delay of at least one cycle.
const LEAST_DELAY_CYCLES: f64 = 1.0;
/// The hold of the command costs half a cycle.
const HOLD_CYCLES: f64 = 0.5;
/// Above this lag of the delay alone, in degrees, drive and mechanics will soon increase it to 90.
const MUCH_DELAY: f64 = 60.0;
/// An all-pass inverts if its phase at f0 differs from 180 degrees by less than this [degrees].
const NEARLY_INVERTED: f64 = 10.0;

/// Warns if the phase of an active stage may differ from the user's expectation.
pub(crate) fn advise(e: &mut Effective<'_>, i: u32, design: &StageDesign, ipc: &Ipc) {
    direct_source(e, i, &design.stage, ipc.enable);
    delay(e, i, design, ipc.delay_cycles);
    polarity(e, i, design);
}

/// Warns that feedback from the load lags more than feedback from the motor. An all-pass at a wrong frequency makes it worse,
/// and only the machine shows which one is right.
fn direct_source(e: &mut Effective<'_>, i: u32, stage: &Stage, enable: Enable) {
    if looks_at_load(stage.mode) && !(has_allpass(stage) && stage.weight() <= 1.0 && enable != Enable::On) {
        let found = format!(
            "stage[{i}] feeds back v_direct, which lags by the drive, the mechanics and the delay: beyond 90 degrees at \
             f0 an all-pass that gives back just this lag is mandatory, or the loop is unstable; the mechanics are not known"
        );
        let allpass = match has_allpass(stage) {
            true => String::new(),
            false => format!("an ALLPASS in filter[{}], ", 1 - stage.first_bandpass()),
        };
        let instead = format!("{allpass}a weight of at most 1, and enable DRYRUN until the machine has shown the lag");
        e.warn(codes::LAG, (Name::DirectSource, [i, 0]), found, Some(instead));
    }
}

/// The delay in the loop of a stage [cycles], as given (P-AXIS-00191) or the minimum, including the hold; and its phase lag
/// at f0 [degrees].
fn delay_lag(stage: &Stage, cycle_time: f64, delay_cycles: Option<u32>) -> (f64, f64) {
    let cycles = delay_cycles.map_or(LEAST_DELAY_CYCLES, f64::from) + HOLD_CYCLES;
    (cycles, 360.0 * stage.f0() * cycle_time * cycles)
}

/// Warns of the phase lag that the delay of the loop causes, which an all-pass compensates. SET_POINT either closes no loop or acts
/// in the position loop, which is slow.
fn delay(e: &mut Effective<'_>, i: u32, StageDesign { stage, cycle_time, .. }: &StageDesign, given: Option<u32>) {
    let (cycles, lag) = delay_lag(stage, *cycle_time, given);
    if lag > MUCH_DELAY && !has_allpass(stage) && !matches!(stage.mode, Mode::SetPoint { .. }) {
        let k = stage.first_bandpass();
        let how = match given {
            Some(given) => format!("{given} cycles (P-AXIS-00191) and half a cycle of the hold"),
            None => format!("{cycles} cycles at the least"),
        };
        let found = format!(
            "stage[{i}] at {} Hz: the delay of the loop alone, {how}, costs {} degrees; beyond 90 degrees in all it excites \
             what it is to damp",
            real_text(stage.f0()),
            rounded(lag)
        );
        let instead =
            Some("an ALLPASS in the other filter, SET_POINT with osc_damping, or a shorter cycle time".to_owned());
        e.warn(codes::DELAY, (Name::FilterF0, [i, k]), found, instead);
    }
}

/// Warns of an all-pass near the frequency of the band-pass: it changes the phase by 180 degrees.
fn polarity(e: &mut Effective<'_>, i: u32, StageDesign { stage, filter, cycle_time, .. }: &StageDesign) {
    for (k, filter) in (0..FILTERS).zip(filter) {
        let Some(FilterDesign { filter, band, .. }) = filter else { continue };
        let phase = kinds::of(filter).and_then(|kind| kind.phase(band, warped(stage.f0(), *cycle_time)));
        let (Some(turn), Some(f0)) = (phase, filter.f0()) else { continue };
        if (turn + 180.0).abs() > NEARLY_INVERTED {
            continue;
        }
        let what = match f0.to_bits() == stage.f0().to_bits() {
            true => "is an all-pass at the f0 of the band-pass".to_owned(),
            false => format!("is an all-pass that turns by {} degrees at the f0 of the band-pass", rounded(turn)),
        };
        let found = format!("stage[{i}].filter[{k}] {what}: it inverts the stage's polarity");
        let instead = Some("an fg_f0 farther from it, unless the inversion is meant".to_owned());
        e.warn(codes::POLARITY, (Name::FilterF0, [i, k]), found, instead);
    }
}

fn has_allpass(stage: &Stage) -> bool {
    stage.filter.iter().any(|filter| filter.kind() == FilterType::Allpass)
}
