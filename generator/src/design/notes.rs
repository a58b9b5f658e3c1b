//! What each coefficient means physically, one line each, for the reviewer of a generated block. No design.

use super::band::{band, edges, frequency, warped};
use super::{bandpass, ipc, response, stage};
use crate::axis::{Axis, DirectSource, Enable, Filter, Mode, Prototype, Stage};
use portable::RealKind;

/// Path prefixes in the tree of coefficients (`stage[0].filter[1]`, `limit`) and what stands there, in the order of the
/// tree; what is not there, or says all in its doc comment, has no note. ASCII; a parameter as the user wrote it, a computed number with seven digits.
#[must_use]
pub fn notes(axis: &Axis) -> Vec<(String, String)> {
    let ipc = &axis.ipc;
    let mut notes = vec![note("cycle_time_ns", of_cycle_time(axis)), note("enable", of_enable(ipc.enable))];
    for (i, stage) in ipc.stage.iter().enumerate() {
        let path = format!("stage[{i}]");
        if let Some(stage) = stage {
            notes.extend(of_stage(&path, stage, axis.cycle_time()));
        }
    }
    notes.push(note("limit", of_limit(axis)));
    notes.push(note("rest", of_rest(axis.real)));
    notes.push(note("fade_cycles", of_fade(axis)));
    notes
}

fn of_cycle_time(axis: &Axis) -> String {
    format!("cycle time {} us, the coefficients hold for no other", digits(f64::from(axis.cycle_time_ns) / 1000.0))
}

fn of_enable(enable: Enable) -> String {
    let word = match enable {
        Enable::Off => "OFF",
        Enable::On => "ON",
        Enable::DryRun => "DRYRUN",
    };
    format!("mode at start: {word} (P-AXIS-00758)")
}

fn of_stage(path: &str, stage: &Stage, cycle_time: f64) -> Vec<(String, String)> {
    let mut notes = vec![note(path, format!("{}, {}", of_mode(stage.mode), of_weight(stage)))];
    if let Some(damping) = stage::osc_damping(stage.mode) {
        notes.push((format!("{path}.oscillation"), of_oscillation(stage.f0(), damping)));
    }
    for (k, filter) in stage.filter.iter().enumerate() {
        let path = format!("{path}.filter[{k}]");
        notes.extend(of_filter(filter, cycle_time).map(|text| (path.clone(), text)));
        notes.extend(of_sections(&path, filter, cycle_time));
    }
    notes.push((format!("{path}.gain"), of_gain(stage, cycle_time)));
    notes
}

fn of_mode(mode: Mode) -> String {
    let (word, source) = match mode {
        Mode::Direct { source: DirectSource::Motor } => ("DIRECT", "v_motor"),
        Mode::Direct { source: DirectSource::Direct } => ("DIRECT", "v_direct"),
        Mode::Indirect { .. } => ("INDIRECT", "v_motor"),
        Mode::SetPoint { .. } => ("SET_POINT", "v_command"),
    };
    format!("{word} (P-AXIS-00753) from {source}")
}

fn of_weight(stage: &Stage) -> String {
    let (num, denom) = (stage.weight_fact_num, stage.weight_fact_denom);
    let written = f64::from(num) / f64::from(denom);
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

fn of_filter(filter: &Filter, cycle_time: f64) -> Option<String> {
    match *filter {
        Filter::NoFilter => None,
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            let [lower, upper] = edges(&band(f0, q_factor, cycle_time)).map(|t| digits(frequency(t, cycle_time)));
            Some(format!(
                "BANDPASS {} order {order} (P-AXIS-00849, 00848, 00750): centre frequency {f0} Hz (P-AXIS-00751), \
                 quality factor {q_factor} (P-AXIS-00752), -3 dB at {lower} and {upper} Hz",
                word(prototype)
            ))
        }
        Filter::Allpass { f0, q_factor } => {
            let [lower, upper] = edges(&band(f0, q_factor, cycle_time)).map(|t| digits(frequency(t, cycle_time)));
            Some(format!(
                "ALLPASS (P-AXIS-00849): -180 deg at {f0} Hz (P-AXIS-00751), quality factor {q_factor} (P-AXIS-00752), \
                 -90 deg at {lower} and -270 deg at {upper} Hz"
            ))
        }
    }
}

fn of_sections(path: &str, filter: &Filter, cycle_time: f64) -> Vec<(String, String)> {
    let Filter::Bandpass { prototype, order, f0, q_factor } = *filter else { return Vec::new() };
    let sections = bandpass::sections(prototype, order, &band(f0, q_factor, cycle_time));
    let line = |(j, section): (usize, &bandpass::Section)| {
        let centre = digits(frequency(section.g, cycle_time));
        let quality = digits(1.0 / section.k);
        let gain = digits(section.c);
        let text = format!(
            "section {} of {order}: centre frequency {centre} Hz, quality factor {quality}, gain {gain} there and 1 at {f0} Hz",
            j + 1
        );
        (format!("{path}.bandpass[{j}]"), text)
    };
    sections.iter().enumerate().map(line).collect()
}

fn of_gain(stage: &Stage, cycle_time: f64) -> String {
    let f0 = stage.f0();
    let h = response::of_stage(&stage::coefficients::<f64>(Some(stage), cycle_time), warped(f0, cycle_time));
    let magnitude = digits(response::magnitude(h));
    let phase = response::phase(h);
    let phase = digits(if phase < -179.9999999 { phase + 360.0 } else { phase });
    format!("-weight, against the vibration; at {f0} Hz the stage adds {magnitude} times its source at {phase} deg")
}

fn of_limit(axis: &Axis) -> String {
    let (fact, v_max) = (axis.ipc.v_add_max_fact, axis.ipc.v_max);
    let limit = digits(ipc::limit(&axis.ipc));
    format!("largest |v_add| = {limit}: {fact} * 0.1 % (P-AXIS-00757) of {v_max} (P-AXIS-00212)")
}

fn of_rest(real: RealKind) -> String {
    let exponent = match real {
        RealKind::F64 => -60,
        RealKind::F32 => -40,
    };
    format!("P-AXIS-00212 * 2^{exponent}: a sum below it is exactly 0")
}

fn of_fade(axis: &Axis) -> String {
    let fade = ipc::fade(&axis.ipc);
    let reason = if fade > axis.ipc.fade { "one period of the lowest f0" } else { "key fade" };
    format!("OFF to ON takes {} s ({reason}), in cycles", digits(fade))
}

fn word(prototype: Prototype) -> &'static str {
    match prototype {
        Prototype::CritDamping => "CRIT_DAMPING",
        Prototype::Butterworth => "BUTTERWORTH",
        Prototype::Bessel => "BESSEL",
    }
}

fn note(path: &str, text: String) -> (String, String) {
    (path.to_owned(), text)
}

/// Seven significant digits, no trailing zeros, the same on every host.
pub fn digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().expect("design: a formatted number is a number");
    if rounded != 0.0 && !(1e-4..1e12).contains(&rounded.abs()) { format!("{rounded:e}") } else { format!("{rounded}") }
}
