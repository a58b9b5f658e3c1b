//! The results as text for readers, and the response as the file for `drive.response`.

use super::{Channel, Excited, Measured, Offset, Vibration, When};
use identification::response::in_db_and_degrees;
use identification::segments::Kind;
use identification::source::Side;
use stability::magnitude;
use std::fmt::Write;

/// First line of the file of a response.
pub const HEAD: &str = "# response from v_cmd to v_motor, measured by axgen\n";

/// The response: real and imaginary part, and the standard error, line by line.
#[must_use]
pub fn response(excited: &Excited) -> String {
    let mut text = format!("{HEAD}# averages: {}\nf [Hz],re,im,se,coherence\n", excited.periods());
    let lines = &excited.lines;
    for (k, hz) in lines.hz.iter().enumerate() {
        let p = lines.response[k];
        let _ = writeln!(text, "{hz:.6},{:.9},{:.9},{:.3e},{:.6}", p.re, p.im, lines.error[k], lines.coherence[k]);
    }
    text
}

/// The report.
#[must_use]
pub fn report(measured: &Measured) -> String {
    let mut text = String::new();
    measured.channels.iter().for_each(|channel| text += &of_channel(channel));
    text += &of_segments(measured);
    measured.offsets.iter().for_each(|offset| text += &of_offset(offset));
    if !measured.vibrations.is_empty() {
        text += "vibrations:\n";
        measured.vibrations.iter().for_each(|vibration| text += &of_vibration(measured, vibration));
    }
    measured.excited.iter().for_each(|excited| text += &of_excited(measured, excited));
    text
}

fn of_channel(channel: &Channel) -> String {
    let timing = &channel.timing;
    let unit = match channel.unit {
        Some(unit) if channel.is_stated => unit.name.to_owned(),
        Some(unit) => format!("{} (plausible)", unit.name),
        None => "unit unknown".to_owned(),
    };
    let every = timing.interval.map_or_else(String::new, |interval| format!(", every {} ms", digits(interval * 1e3)));
    let jitter =
        if timing.jitter > 0.0 { format!(", jitter {} ms", digits(timing.jitter * 1e3)) } else { String::new() };
    let missing = if timing.missing > 0 { format!(", {} missing", timing.missing) } else { String::new() };
    format!("{}: {unit}, {} samples{every}{jitter}{missing}\n", channel.signal, channel.values.len())
}

/// A number without digits that only its binary form has.
fn digits(value: f64) -> String {
    (libm::round(value * 1e6) / 1e6).to_string()
}

fn of_segments(measured: &Measured) -> String {
    let Some(record) = measured.record.as_ref().filter(|_| !measured.segments.is_empty()) else {
        return String::new();
    };
    let of = |kind: Kind| {
        let segments = measured.segments.iter().filter(|segment| segment.kind == kind);
        let (count, samples) = segments.fold((0, 0), |(n, sum), of| (n + 1, sum + of.samples.len()));
        format!("{count} {} {:.2} s", word(kind), samples as f64 * record.cycle)
    };
    let all = [Kind::Accelerating, Kind::Driving, Kind::Rest].map(of).join(", ");
    let Some(speeds) = Some(&measured.windows.driving).filter(|driving| !driving.is_empty()) else {
        return format!("segments: {all}\n");
    };
    let speeds: Vec<String> = speeds.iter().map(|(speed, _)| format!("{speed:.4}")).collect();
    let unit = record.command_unit().unwrap_or_else(|| "in the unit of the command".to_owned());
    format!("segments: {all}; constant speed {} {unit}\n", speeds.join(", "))
}

/// Its name in a machine-readable report.
#[must_use]
pub fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Accelerating => "accelerating",
        Kind::Driving => "driving",
        Kind::Rest => "rest",
    }
}

fn of_offset(offset: &Offset) -> String {
    let Offset { of, to, time } = offset;
    match time {
        Some(time) => format!("{of} is {:.3} +-{:.3} ms later than {to}\n", time.seconds * 1e3, time.error * 1e3),
        None => format!("whether {of} is later than {to} is unknown\n"),
    }
}

fn of_vibration(measured: &Measured, vibration: &Vibration) -> String {
    let unit = measured.record.as_ref().and_then(|record| record.unit(vibration.channel));
    let unit = unit.map_or_else(String::new, |unit| format!(" {}", unit.name));
    let when = match vibration.when {
        When::Driving => "while driving",
        When::Ramps => "after ramps",
        When::Excited => "excited",
    };
    let amplitude = match vibration.when {
        When::Excited => format!("|P| {:.3}", vibration.amplitude),
        When::Driving | When::Ramps => format!("amplitude {:.4}{unit}", vibration.amplitude),
    };
    let mut text =
        format!("  {:.2} +-{:.2} Hz  {} {when}, {amplitude}", vibration.hz, vibration.hz_error, vibration.channel);
    if let Some([damping, error]) = vibration.damping {
        let _ = write!(text, ", damping {damping:.4} +-{error:.4}");
    }
    let order = vibration.order.map(|order| format!("order: {order:.4} per unit of way"));
    let notes = [
        vibration.is_forced.then(|| "forced: no damping".to_owned()),
        order,
        vibration.competes.then(|| "another peak competes".to_owned()),
        vibration.is_at_edge.then(|| "at the edge of the spectrum".to_owned()),
        vibration.source.map(|side| format!("enters at the {}", side_word(side))),
    ];
    notes.into_iter().flatten().for_each(|note| text += &format!(", {note}"));
    text + "\n"
}

/// Its name in a machine-readable report.
#[must_use]
pub fn side_word(side: Side) -> &'static str {
    match side {
        Side::Motor => "motor",
        Side::Load => "load",
    }
}

fn of_excited(measured: &Measured, excited: &Excited) -> String {
    let (sequence, lines) = (&excited.sequence, &excited.lines);
    let mut text = format!(
        "excitation {}x{}: {} periods of {} cycles measured, {} lines",
        sequence.bits(),
        sequence.clock(),
        excited.periods(),
        sequence.period(),
        lines.hz.len()
    );
    if let Some([from, to]) = lines.band() {
        let _ = write!(text, " from {from:.3} to {to:.1} Hz");
    }
    text += "\n";
    let mut relative: Vec<f64> =
        lines.error.iter().zip(&lines.response).map(|(error, p)| error / magnitude(*p)).collect();
    relative.sort_by(f64::total_cmp);
    if let Some(middle) = relative.get(relative.len() / 2) {
        let [db, degrees] = in_db_and_degrees(*middle);
        let _ =
            writeln!(text, "standard error of the response, in the middle of all lines: {db:.2} dB, {degrees:.2} deg");
    }
    if let (Some(time), Some(record)) = (excited.dead_time, &measured.record) {
        let cycles = time.seconds / record.cycle;
        let _ = writeln!(text, "dead time {:.3} ms, {cycles:.2} cycles", time.seconds * 1e3);
    }
    text
}
