//! The picture of a scenario: the drawn signals and their units. Drawing is in `svg`.

use super::Scenario;
use crate::samples::Samples;
use crate::subject::number;
use crate::svg::{Across, Curve, Curves, Over, Panel, Part, Picture, Rows};
use generator::axis::Changeover;
use generator::blocks::Designed;

/// Maximum number of points of a curve.
const MOST: usize = 600;
/// 0.001 deg/s in 1 rpm, 0.001 deg in 1 deg, um in 1 mm, um/s in 1 mm/min.
const RPM: f64 = 6000.0;
const DEGREE: f64 = 1000.0;
const MM: f64 = 1000.0;
const MM_MIN: f64 = 1000.0 / 60.0;

/// The states of a spindle, by their numbers.
const STATES: [&str; 5] = ["POSITION", "TO_VELOCITY", "VELOCITY", "BRAKE", "TO_POSITION"];

/// The picture of a scenario of that name.
#[must_use]
pub fn of(scenario: &Scenario, name: &str, designed: &Designed) -> Picture {
    let run = Run { scenario, cycle: designed.axis.cycle_time() };
    let events = scenario.steps.iter().filter(|step| step.to > step.from);
    let events = events.map(|step| {
        (run.time(step.from), step.number.map_or_else(|| format!("line {}", step.line), |number| format!("N{number}")))
    });
    let panels = if scenario.outputs.shape.signals.iter().any(|signal| signal.name == "spindle_state") {
        spindle(&run, designed)
    } else {
        path(&run)
    };
    let across = Across::Time { until: run.time(scenario.inputs.len()) };
    let parts = vec![Part::Over(Over { across, events: events.collect(), panels })];
    Picture { title: name.to_owned(), setup: vec![setup(scenario, designed)], parts }
}

fn setup(scenario: &Scenario, designed: &Designed) -> String {
    let mode = match designed.axis.control.spindle.as_ref().map(|of| &of.drive) {
        Some(Changeover::Drive { velocity_mode, .. }) => format!("; operation mode {velocity_mode}: velocity control"),
        _ => String::new(),
    };
    let [name, cycles] = [designed.axis.name.clone(), scenario.inputs.len().to_string()];
    let cycle = f64::from(designed.axis.cycle_time_ns) / 1e6;
    format!("axis {name}, {cycles} cycles of {cycle} ms, simulated drive{mode}")
}

fn spindle(run: &Run<'_>, designed: &Designed) -> Vec<Panel> {
    let of = designed.axis.control.spindle.as_ref();
    let limits = of.map_or([0.0; 2], |of| [of.v_velocity_control_on, of.v_position_control_on].map(f64::from));
    let marks = [("Von", limits[0]), ("Voff", limits[1])]
        .into_iter()
        .flat_map(|(name, v)| [1.0, -1.0].map(|sign| (sign * v / RPM, name.to_owned())));
    let [command, actual] = ["v_spindle", "v_actual"].map(|name| run.values(name));
    let state = run.values("spindle_state");
    let states =
        STATES.into_iter().zip(0..).map(|(name, number)| (name.to_owned(), run.when(&state, f64::from(number))));
    let mut panels = vec![
        Panel::Curves(Curves {
            name: "speed [rpm]".to_owned(),
            scale: None,
            marks: marks.collect(),
            curves: vec![run.curve("command", &command, RPM, None), run.curve("actual", &actual, RPM, None)],
        }),
        Panel::Curves(Curves {
            name: "position [deg]".to_owned(),
            scale: Some([0.0, 360.0, 90.0]),
            marks: Vec::new(),
            curves: vec![
                run.curve("command", &run.values("x_spindle"), DEGREE, Some(180.0)),
                run.curve("actual", &run.values("x_actual"), DEGREE, Some(180.0)),
            ],
        }),
        Panel::Rows(Rows { rows: states.collect() }),
    ];
    if let Some(Changeover::Drive { velocity_mode, .. }) = of.map(|of| &of.drive) {
        let mode = f64::from(*velocity_mode);
        let rows = [("requested", "operation_mode"), ("displayed", "operation_mode_display")];
        let rows = rows.map(|(what, signal)| (format!("mode {mode} {what}"), run.when(&run.values(signal), mode)));
        panels.push(Panel::Rows(Rows { rows: rows.into() }));
    }
    panels
}

fn path(run: &Run<'_>) -> Vec<Panel> {
    let panel = |name: &str, scale, signals: &[(&str, &str)], unit| {
        let curves = signals.iter().map(|(name, signal)| run.curve(name, &run.values(signal), unit, None));
        let curves: Vec<Curve> = curves.filter(|curve| !curve.pieces.is_empty()).collect();
        let is_there = !curves.is_empty();
        is_there.then(|| Panel::Curves(Curves { name: name.to_owned(), scale, curves, ..Curves::default() }))
    };
    let velocities = [("command", "v_interpolator"), ("feedforward", "v_feedforward"), ("motor", "v_motor")];
    let mut panels = vec![
        panel("velocity [mm/min]", None, &velocities, MM_MIN),
        panel("position [mm]", None, &[("command", "x_command"), ("actual", "x_actual")], MM),
    ];
    let [command, actual] = ["x_command", "x_actual"].map(|name| run.values(name));
    if !actual.is_empty() {
        let lag: Vec<f64> = command.iter().zip(&actual).map(|(command, actual)| command - actual).collect();
        panels.push(Some(Panel::curves("position lag [mm]", vec![run.curve("lag", &lag, MM, None)])));
    }
    if run.values("v_add").iter().any(|v_add| *v_add != 0.0) {
        panels.push(panel("v_add [mm/s]", None, &[("v_add", "v_add")], MM));
    }
    let percentage = [("G136", "feedforward_percentage")];
    panels.push(panel("feedforward [%]", Some([0.0, 100.0, 50.0]), &percentage, 1.0));
    let active = run.values("feedforward_active");
    if !active.is_empty() {
        panels.push(Some(Panel::Rows(Rows { rows: vec![("G135".to_owned(), run.when(&active, 1.0))] })));
    }
    panels.into_iter().flatten().collect()
}

/// A scenario over time.
struct Run<'s> {
    scenario: &'s Scenario,
    /// [s]
    cycle: f64,
}

impl Run<'_> {
    fn time(&self, sample: usize) -> f64 {
        sample as f64 * self.cycle
    }

    /// All values of a signal; empty if the block does not have it.
    fn values(&self, name: &str) -> Vec<f64> {
        let of = |run: &Samples| {
            let at = run.shape.place(name)?;
            let mut values = Vec::new();
            let value = |sample| {
                run.read(sample, &mut values);
                number(values[at])
            };
            Some((0..run.len()).map(value).collect())
        };
        of(&self.scenario.outputs).or_else(|| of(&self.scenario.inputs)).unwrap_or_default()
    }

    /// Some of the values as a curve, interrupted where it jumps by more than `jump`.
    fn curve(&self, name: &str, values: &[f64], unit: f64, jump: Option<f64>) -> Curve {
        let step = values.len().div_ceil(MOST).max(1);
        let points = values.iter().enumerate().step_by(step);
        let points = points.map(|(sample, value)| (self.time(sample), value / unit));
        Curve::broken(name, points, jump.unwrap_or(f64::INFINITY))
    }

    /// The times in which a signal has a value: from the first of its samples to the first one after them.
    fn when(&self, values: &[f64], wanted: f64) -> Vec<[f64; 2]> {
        let mut spans: Vec<[usize; 2]> = Vec::new();
        for (sample, _) in values.iter().enumerate().filter(|(_, value)| value.to_bits() == wanted.to_bits()) {
            match spans.last_mut().filter(|[_, to]| *to == sample) {
                Some([_, to]) => *to = sample + 1,
                None => spans.push([sample, sample + 1]),
            }
        }
        spans.into_iter().map(|span| span.map(|sample| self.time(sample))).collect()
    }
}
