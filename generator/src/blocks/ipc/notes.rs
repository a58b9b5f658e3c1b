//! The physical meaning of each coefficient, one line each, for the reviewer of a generated block. No design.

use super::design::rest_exponent;
use super::filter;
use super::stage::{Place, Section, StageDesign};
use crate::axis::{Axis, Mode, Stage};
use crate::blocks::designed::Designed;
use crate::design::band::{frequency, warped};
use crate::design::response;
use crate::number::digits;
use crate::parameters::words::Words;
use reference::design::sections::Shape;

/// Path prefixes in the tree of coefficients (`stage[0].filter[1]`, `limit`) with their texts, in the order of the tree. A
/// coefficient that is absent, or whose doc comment is sufficient, has no note. ASCII; a parameter as the user wrote it, a
/// computed number with seven digits.
pub(crate) fn notes(designed: &Designed) -> Vec<(String, String)> {
    let axis = &designed.axis;
    let enable = format!("mode at start: {} (P-AXIS-00758)", axis.ipc.enable.name());
    let mut notes = vec![note("cycle_time_ns", cycle_time(axis)), note("enable", enable)];
    for design in designed.stage.iter().flatten() {
        notes.extend(of_stage(design));
    }
    notes.push(note("limit", of_limit(axis)));
    let of_sum = "2 times the bound of the sum for |v| <= P-AXIS-00212, at least 2 times the limit";
    notes.push(note("sum_limit", of_sum.to_owned()));
    let rest = rest_exponent(axis.real);
    notes.push(note("rest", format!("rest threshold of the sum: P-AXIS-00212 * 2^{rest}")));
    notes.push(note("fade_cycles", of_fade(axis)));
    if axis.ipc.ride_through > 0 {
        let of_ride = "key ride_through: the last good sample replaces up to this number of consecutive bad samples";
        notes.push(note("ride_through", of_ride.to_owned()));
    }
    let watch = &designed.ipc.watch;
    if watch.active {
        let milliseconds = digits(f64::from(watch.block_cycles) * axis.cycle_time() * 1e3);
        let of_block = format!("key watch: the watch evaluates the sum in blocks of {milliseconds} ms");
        notes.push(note("watch.block_cycles", of_block));
        let of_alarm = format!(
            "trips after {} consecutive blocks in which the sum reaches both limits and does not decay",
            watch.alarm / 2
        );
        notes.push(note("watch.alarm", of_alarm));
    }
    notes
}

/// The note that every block has.
pub(crate) fn cycle_time(axis: &Axis) -> String {
    format!(
        "cycle time {} us; the coefficients are valid only for this cycle time",
        digits(f64::from(axis.cycle_time_ns) / 1000.0)
    )
}

fn of_stage(design: &StageDesign) -> Vec<(String, String)> {
    let stage = &design.stage;
    let path = format!("stage[{}]", design.index);
    let mut notes = vec![note(&path, format!("{}, {}", of_mode(stage.mode), of_weight(stage)))];
    let sections = |of: Option<usize>| {
        let of_filter = design
            .section
            .iter()
            .filter(move |section| section.element.filter.as_ref().map(|place| place.filter) == of);
        of_filter.filter_map(|section| Some((section.element.to_string(), of_section(section, design)?)))
    };
    notes.extend(sections(None));
    for filter in design.filter.iter().flatten() {
        notes.extend(filter::note(filter).map(|text| (format!("{path}.filter[{}]", filter.index), text)));
        notes.extend(sections(Some(filter.index)));
    }
    notes.push((format!("{path}.gain"), of_gain(design)));
    notes
}

fn of_mode(mode: Mode) -> String {
    let text = mode.text();
    let (word, source) = text.split_once(' ').unwrap_or((&text, ""));
    format!("{word} (P-AXIS-00753) {source}")
}

fn of_weight(stage: &Stage) -> String {
    let (num, denom) = (stage.weight_fact_num, stage.weight_fact_denom);
    let written = stage.asked_weight();
    let cap = if written > Stage::MAX_WEIGHT { format!(", capped at {}", Stage::MAX_WEIGHT) } else { String::new() };
    format!("weight {num}/{denom} = {} (P-AXIS-00754/00755){cap}", digits(written))
}

fn of_oscillation(f0: f64, damping: f64) -> String {
    let lag = 1.0 / (2.0 * damping); // H(f0) = 1 - j lag
    let gain = digits(libm::sqrt(1.0 + lag * lag));
    let phase = digits(-libm::atan(lag).to_degrees());
    format!(
        "simulated oscillation of the load, f0 of the first BANDPASS {f0} Hz (P-AXIS-00751), damping ratio {damping} \
         (P-AXIS-00850): gain 1 at DC, {gain} and {phase} deg at f0"
    )
}

/// An all-pass is fully described by the note of its filter.
fn of_section(section: &Section, design: &StageDesign) -> Option<String> {
    let stage = &design.stage;
    let Some(Place { filter, section: index, .. }) = &section.element.filter else {
        return Some(of_oscillation(stage.f0(), stage.mode.osc_damping()?));
    };
    let Shape { g, k, c } = section.shape;
    let [centre, quality, gain] = [frequency(g, design.cycle_time), 1.0 / k, c].map(digits);
    filter::of(&stage.filter[*filter])?.note_of_section(*index, [centre, quality, gain])
}

fn of_gain(design: &StageDesign) -> String {
    let f0 = design.stage.f0();
    let h = response::of_stage(&design.coeffs, warped(f0, design.cycle_time));
    let [magnitude, phase] = [response::magnitude(h), response::angle(h)].map(digits);
    format!(
        "-weight, against the vibration; at {f0} Hz the stage output is {magnitude} times its input, phase {phase} deg"
    )
}

fn of_limit(axis: &Axis) -> String {
    let (fact, v_max) = (axis.ipc.v_add_max_fact, axis.ipc.v_max);
    let limit = digits(axis.ipc.limit());
    format!("largest |v_add| = {limit}: {fact} * 0.1 % (P-AXIS-00757) of {v_max} (P-AXIS-00212)")
}

fn of_fade(axis: &Axis) -> String {
    let fade = axis.ipc.fade_time();
    let reason = if fade > axis.ipc.fade { "one period of the lowest f0" } else { "key fade" };
    format!("fade from OFF to ON: {} s ({reason})", digits(fade))
}

pub(crate) fn note(path: &str, text: String) -> (String, String) {
    (path.to_owned(), text)
}
