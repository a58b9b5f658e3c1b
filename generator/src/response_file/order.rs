//! Checks of the frequencies: above 0, rising, enough of them, without a gap, below half the sampling frequency.

use super::Said;
use super::numbers::Line;
use crate::codes;
use crate::number::significant;
use portable::Extreme;

/// Fewer lines are not a response.
const LEAST: usize = 10;
/// A distance of this multiple of the larger neighbouring one is a gap: one or several lines are missing. One missing line
/// doubles it.
const DOUBTFUL: f64 = 1.7;
const GAP: f64 = 2.6;

/// The lines below half the sampling frequency, if they are in order.
pub(super) fn check(mut lines: Vec<Line>, names: [usize; 2], cycle_time: f64, said: &mut Said<'_>) -> Vec<Line> {
    zero(&mut lines, said);
    rising(&lines, said);
    if said.report.has_errors() {
        return lines;
    }
    let half = 0.5 / cycle_time;
    let within = lines.partition_point(|line| line.hz < half);
    if let Some(first) = lines.get(within) {
        let found = format!("{} lines from {} Hz on are left out", lines.len() - within, hz(first.hz));
        let place = [first.line, first.columns[0]];
        let allowed = format!("below {} Hz, half of the sampling frequency", hz(half));
        said.push(said.warning(codes::BEYOND_NYQUIST, place, found).allowed(allowed));
    }
    lines.truncate(within);
    if lines.len() < LEAST {
        let found = format!("{} lines below {} Hz", lines.len(), hz(half));
        said.push(
            said.error(codes::TOO_FEW_LINES, names, found)
                .allowed(format!("{LEAST} lines or more"))
                .instead("a measurement with a finer resolution, or a smaller bandwidth; `f [kHz]` if they are in kHz"),
        );
    }
    gaps(&lines, said);
    lines
}

/// Leaves out the line at 0 Hz, which an FFT has and which contains no information.
fn zero(lines: &mut Vec<Line>, said: &mut Said<'_>) {
    let is_zero = |line: &Line| line.hz.abs() <= 0.0;
    if lines.first().is_some_and(is_zero) {
        let first = lines.remove(0);
        let found = "the line at 0 Hz is left out";
        said.push(said.warning(codes::ZERO_HERTZ, [first.line, first.columns[0]], found).allowed("above 0 Hz"));
    }
    for line in lines.iter().filter(|line| line.hz <= 0.0) {
        let found = format!("a frequency of {} Hz", hz(line.hz));
        said.push(
            said.error(codes::NEGATIVE_FREQUENCY, [line.line, line.columns[0]], found)
                .allowed("above 0 Hz")
                .instead("the one-sided response: the lines above 0 Hz only"),
        );
    }
}

/// Reports the first line that does not rise, and the number of these lines.
fn rising(lines: &[Line], said: &mut Said<'_>) {
    let wrong: Vec<&[Line]> = lines.windows(2).filter(|pair| pair[1].hz <= pair[0].hz).collect();
    let Some([before, line]) = wrong.first().and_then(|pair| <&[Line; 2]>::try_from(*pair).ok()) else { return };
    let is_same = line.hz >= before.hz;
    let more = match wrong.len() {
        1 => String::new(),
        count => format!("; {} lines more", count - 1),
    };
    let found = match is_same {
        true => format!("{} Hz a second time, as in line {}{more}", hz(line.hz), before.line),
        false => format!("{} Hz below {} Hz in line {}{more}", hz(line.hz), hz(before.hz), before.line),
    };
    let instead = match is_same {
        true => "one measurement only, or their mean",
        false => "the lines sorted by their frequencies, one measurement only",
    };
    let place = [line.line, line.columns[0]];
    said.push(
        said.error(codes::NOT_RISING, place, found).allowed("frequencies that rise from line to line").instead(instead),
    );
}

/// Reports lines that were removed: a smooth curve through the gap hides their values.
fn gaps(lines: &[Line], said: &mut Said<'_>) {
    let distance = |index: usize| Some(lines.get(index + 1)?.hz - lines.get(index)?.hz);
    for index in 0..lines.len().saturating_sub(1) {
        let before = index.checked_sub(1).and_then(distance);
        let around = [before, distance(index + 1)].into_iter().flatten().fold(0.0, f64::larger);
        let own = distance(index).unwrap_or(0.0);
        if around <= 0.0 || own < DOUBTFUL * around {
            continue;
        }
        let (from, to) = (&lines[index], &lines[index + 1]);
        let place = [to.line, to.columns[0]];
        let found = format!(
            "no line between {} Hz and {} Hz: {} times the distance of the lines around",
            hz(from.hz),
            hz(to.hz),
            significant(own / around, 2)
        );
        if own < GAP * around {
            said.push(said.warning(codes::LINE_MISSING, place, found).instead("every line of the measurement"));
        } else {
            said.push(
                said.error(codes::GAP, place, found)
                    .allowed(format!("at most {GAP} times"))
                    .instead("every line of the measurement, weak ones too: their coherence says what they are worth"),
            );
        }
    }
}

/// A frequency in a message.
pub(super) fn hz(value: f64) -> String {
    significant(value, 5)
}
