//! The picture of a simulation: off against on, and what was added. How a picture is drawn is in `svg`.

use super::{Moved, Simulation};
use crate::svg::{self, Curve, Curves, Panel, Picture};
use machine::closed_loop::Record;

/// What every picture begins with.
pub const HEAD: &str = svg::HEAD;

/// Points of a curve, at most: the vibration must be seen.
const MOST: usize = 4000;

/// The picture of the axis of that name.
#[must_use]
pub fn svg(simulation: &Simulation, axis: &str) -> String {
    let [Some(off), Some(on)] = [simulation.rows.first(), simulation.rows.last()].map(|row| row.map(|row| &row.record))
    else {
        return String::new();
    };
    let (setup, name, seen): (_, _, fn(&Record, usize) -> f64) = match simulation.moved {
        Moved::Demonstration => ("the demonstration plant", "load acceleration [m/s^2]", |record, n| record.sensor[n]),
        Moved::Drive => {
            ("a drive without mechanics, ripple of 1 mm/s at each f0", "v_motor - planned [mm/s]", |record, n| {
                record.signals[n].v_motor / 1e3 - record.v_planned[n] * 1e3
            })
        }
    };
    let curves =
        |name: &str, curves| Panel::Curves(Curves { name: name.to_owned(), scale: None, marks: Vec::new(), curves });
    svg::svg(&Picture {
        title: format!("axis {axis}"),
        setup: setup.to_owned(),
        until: on.command.len() as f64 * on.cycle,
        events: Vec::new(),
        panels: vec![
            curves(name, vec![curve("off", off, seen), curve("on", on, seen)]),
            curves("v_add [mm/s]", vec![curve("v_add", on, |record, n| record.v_add[n] / 1e3)]),
        ],
    })
}

fn curve(name: &str, record: &Record, value: impl Fn(&Record, usize) -> f64) -> Curve {
    let step = record.command.len().div_ceil(MOST).max(1);
    let points = (0..record.command.len()).step_by(step).map(|n| (n as f64 * record.cycle, value(record, n)));
    Curve { name: name.to_owned(), pieces: vec![points.collect()] }
}
