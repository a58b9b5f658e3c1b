//! What a recorder on the controller would save from the simulated machine: moves with every stage off, and a move with the block
//! `excitation`. The names are those that `axgen measure` reads.

use super::row::Moved;
use super::setting::{self, ON, Setting};
use crate::analysis::stages;
use crate::case::named_block;
use crate::subject::Subject;
use generator::blocks::Designed;
use machine::closed_loop::{Record, Signals, UM};
use machine::sequence::Sequence;
use portable::peak;
use std::fmt::Write;

/// First line of a recording, up to the signals that only one kind of it has: for translatory axes, then for rotary axes and
/// spindles.
pub const HEADS: [&str; 2] = [
    "time [s],x_command [mm],x_actual [mm],v_command [um/s],v_motor [um/s],a_load [m/s^2]",
    "time [s],x_command [deg],x_actual [deg],v_command [0.001 deg/s],v_motor [0.001 deg/s],a_load [deg/s^2]",
];
/// Speed of the move by default, in amplitudes of the excitation: above the 2.5 that friction asks for.
const SPEED: f64 = 4.0;
/// Time at constant speed before the excitation and after it [s].
const AROUND: f64 = 0.5;

/// Moves forward and back, nothing added; a dwell [s] takes the place of the usual one. `noise`: its rms value as a
/// part of the peak of what is measured.
#[must_use]
pub fn moves(designed: &Designed, moved: Moved, dwell: Option<f64>, noise: f64) -> String {
    let set = Setting::new(designed, moved, dwell, &[]);
    csv(designed, &set.run(&set.sequence, &mut |_| 0.0), None, noise)
}

/// A move at a constant speed [m/s], by default 4 amplitudes of the excitation, with the excitation of the axis from
/// its start to its end.
///
/// # Errors
/// The axis does not have the block `excitation`, or the block reports an error.
pub fn excited(designed: &Designed, moved: Moved, speed: Option<f64>, noise: f64) -> Result<String, String> {
    let set = Setting::new(designed, moved, None, &[]);
    let mut subject = Subject::start(designed, &named_block(designed, "excitation")?);
    let excitation = designed.axis.excitation.as_ref().map(|excitation| excitation.at(designed.axis.cycle_time()));
    let excitation = excitation.ok_or("the axis has no excitation")?;
    let duration = excitation.duration();
    let speed = speed.unwrap_or(SPEED * excitation.amplitude / UM);
    let sequence = Sequence { speed, dwell: duration + 2.0 * AROUND, ..Sequence::DEMONSTRATION };
    let planned = sequence.planned(set.cycle);
    let from = planned.ramps.first().map_or(0, |[_, end]| *end) + set.cycles(AROUND);
    let (mut n, mut v_excite) = (0, Vec::new());
    let record = set.run(&sequence, &mut |signals: &Signals| {
        subject.set("hold_to_run", f64::from(u8::from(n >= from)));
        subject.cycle(signals);
        subject.record_anew();
        n += 1;
        v_excite.push(subject.get("v_excite"));
        subject.get("v_excite")
    });
    let error = subject.get("error_id");
    if error != 0.0 {
        return Err(format!("error {error} of the block `excitation`"));
    }
    let text = csv(designed, &record, Some(&v_excite), noise);
    // Of the way forward, without its end.
    let lines = 1 + from + set.cycles(duration + AROUND);
    Ok(text.split_inclusive('\n').take(lines).collect())
}

/// All inputs and outputs of the block `ipc` in mode ON during the moves, for `axgen run --compare`.
///
/// # Errors
/// The axis does not have the block.
pub fn of_block(designed: &Designed, moved: Moved, dwell: Option<f64>) -> Result<String, String> {
    let set = Setting::new(designed, moved, dwell, &stages(designed).collect::<Vec<_>>());
    let mut subject = setting::block(designed, ON)?;
    set.run(&set.sequence, &mut |signals| subject.cycle(signals));
    Ok(subject.csv())
}

/// A recording as text; `v_excite`: of each cycle, with the command to the drive. A degree of a rotary axis is simulated as a
/// millimetre.
fn csv(designed: &Designed, record: &Record, v_excite: Option<&[f64]>, noise: f64) -> String {
    let is_rotary = designed.axis.control.is_rotary;
    let (unit, per_metre) = if is_rotary { ("0.001 deg/s", 1e3) } else { ("um/s", 1.0) };
    let mut source = Noise(1);
    let mut noisy = |values: Vec<f64>| -> Vec<f64> {
        let rms = noise * peak(&values);
        values.into_iter().map(|value| if rms > 0.0 { value + rms * source.next() } else { value }).collect()
    };
    let v_motor = noisy(record.signals.iter().map(|of| of.v_motor).collect());
    let a_load = noisy(record.sensor.iter().map(|a| a * per_metre).collect());
    let more = v_excite.map_or_else(String::new, |_| format!(",v_excite [{unit}],v_cmd [{unit}]"));
    let mut text = format!("{}{more}\n", HEADS[usize::from(is_rotary)]);
    for (n, x) in record.command.iter().enumerate() {
        let v_command = record.signals[n].v_command;
        let [x, x_actual] = [*x, record.seen[n]].map(|x| x * 1e3);
        let time = n as f64 * record.cycle;
        let _ = write!(text, "{time:.6},{x:.6},{x_actual:.6},{v_command:.3},{:.3},{:.6}", v_motor[n], a_load[n]);
        if let Some(v_excite) = v_excite {
            let _ = write!(text, ",{:.3},{:.3}", v_excite[n], v_command + v_excite[n]);
        }
        text.push('\n');
    }
    text
}

/// White noise with an rms value of 1, the same in every run.
struct Noise(u64);

impl Noise {
    /// The sum of twelve even values has a variance of 1.
    fn next(&mut self) -> f64 {
        let mut even = || {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| even()).sum::<f64>() - 6.0
    }
}
