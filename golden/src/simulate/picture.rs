//! The picture of a simulation: off and on, over time and as spectra, and v_add. Drawing is in `svg`.

use super::{Moved, Row, Simulation};
use crate::analysis::f0_events;
use crate::svg::{Across, Curve, Over, Panel, Part, Picture};
use machine::closed_loop::Record;
use machine::measure::{self, Window, spectrum};
use portable::Extreme;

/// Maximum number of points of a curve: the vibration must be visible.
const MOST: usize = 2500;
/// Start of the spectra [Hz]; they end at this factor of the highest f0, or at the Nyquist frequency.
const LOWEST: f64 = 5.0;
const HIGHEST: f64 = 2.5;

/// A signal of a record, cycle by cycle.
type Signal = fn(&Record, usize) -> f64;

/// The picture of the axis of that name; `None` if nothing was run.
#[must_use]
pub fn of(simulation: &Simulation, axis: &str) -> Option<Picture> {
    let [off, on] = [simulation.rows.first()?, simulation.rows.last()?];
    let both = [("off", &off.record), ("on", &on.record)];
    let ([setup, name, unit], seen) = vibration(simulation.moved);
    let time = Over {
        across: Across::Time { until: on.record.command.len() as f64 * on.record.cycle },
        events: Vec::new(),
        panels: vec![
            Panel::curves(format!("{name} [{unit}]"), both.map(|(name, record)| curve(name, record, seen)).into()),
            Panel::curves("v_add [mm/s]", vec![curve("v_add", &on.record, |record, n| record.v_add[n] / 1e3)]),
        ],
    };
    let nyquist = 0.5 / on.record.cycle;
    let highest = simulation.stages.iter().map(|(_, f0)| *f0).fold(2.0 * LOWEST, f64::larger);
    let to = nyquist.smaller(highest * HIGHEST);
    let spectra = |windows: fn(&Record) -> Vec<Window>| {
        both.map(|(name, record)| of_spectrum(name, record, &windows(record), seen, [LOWEST, to])).into()
    };
    let mut panels =
        vec![Panel::curves(format!("at constant speed [{unit}]"), spectra(|record| measure::dwells(record).collect()))];
    if simulation.moved == Moved::Demonstration {
        panels.push(Panel::curves(
            format!("around the ramps [{unit}]"),
            spectra(|record| measure::ramps(record).collect()),
        ));
    }
    let frequency =
        Over { across: Across::Frequency { from: LOWEST, to }, events: f0_events(&simulation.stages), panels };
    Some(Picture {
        title: format!("axis {axis}"),
        setup: [setup.to_owned()].into_iter().chain([off, on].map(numbers)).collect(),
        parts: vec![Part::Over(time), Part::Over(frequency)],
    })
}

/// The setup, and the signal that shows the vibration: its name, its unit and itself.
fn vibration(moved: Moved) -> ([&'static str; 3], Signal) {
    match moved {
        Moved::Demonstration => {
            (["the demonstration plant", "load acceleration", "m/s^2"], |record, n| record.sensor[n])
        }
        Moved::Drive => {
            (["a drive without mechanics, ripple of 1 mm/s at each f0", "v_motor - planned", "mm/s"], |record, n| {
                record.signals[n].v_motor / 1e3 - record.v_planned[n] * 1e3
            })
        }
    }
}

/// The figures of a run, below the title.
fn numbers(row: &Row) -> String {
    let (error, peak) = (row.following_error, row.peak_v_add / 1e3);
    format!("{}: following error {error:.2} mm, peak v_add {peak:.1} mm/s, Ms {}", row.name, row.ms_in_words())
}

fn curve(name: &str, record: &Record, value: Signal) -> Curve {
    let step = record.command.len().div_ceil(MOST).max(1);
    let points = (0..record.command.len()).step_by(step).map(|n| (n as f64 * record.cycle, value(record, n)));
    Curve::new(name, points.collect())
}

/// The mean amplitude over some windows, line by line.
fn of_spectrum(name: &str, record: &Record, windows: &[Window], seen: Signal, band: [f64; 2]) -> Curve {
    let shortest = windows.iter().map(ExactSizeIterator::len).min().unwrap_or(0);
    let mut sum: Vec<[f64; 2]> = Vec::new();
    for window in windows {
        let values = measure::without_mean(window.clone().take(shortest).map(|n| seen(record, n)));
        let lines = spectrum(&values, record.cycle, band);
        if sum.is_empty() {
            sum = lines;
        } else {
            sum.iter_mut().zip(lines).for_each(|(sum, [_, amplitude])| sum[1] += amplitude);
        }
    }
    let points = sum.iter().map(|[hz, amplitude]| (*hz, amplitude / windows.len() as f64)).collect();
    Curve::new(name, points)
}
