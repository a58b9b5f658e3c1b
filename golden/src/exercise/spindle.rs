//! The partner of a spindle: an operator, an interpolator, and a drive that is occasionally switched off, keeps its mode or
//! loses samples. It depends only on the outputs of the block.

use crate::engine::{self, Cycle};
use crate::samples::Shape;
use crate::scenario::spindle_machine::{self, Machine};
use crate::stimulus::Partner;
use crate::subject::{literal, number};
use generator::axis::{Axis, Spindle};
use generator::blocks::{Block, Designed};
use machine::grid::shortest;
use machine::profile::Error;
use machine::spindle::interpolator::{Commanded, Seen};
use machine::spindle::operator::{Bad, Operator};
use portable::{Extreme, Literal, RealKind};

/// The position of the spindle at the start [0.001 deg].
const START: f64 = 10_000.0;
/// Distance of the actual position from the target at which a job is done [0.001 deg].
const WINDOW: f64 = 100.0;
/// All inputs for requests.
const REQUESTS: [&str; 6] = ["m3", "m4", "m5", "m19", "putax", "g74"];

/// An operator, an interpolator, a drive, and the reference of the block.
pub(super) struct Machinery<'a> {
    machine: Machine<'a>,
    step: Cycle,
    signals: Signals,
    answers: Vec<Literal>,
    operator: Operator,
    /// the mode displayed by the drive
    display: i32,
    is_on: bool,
    feedforward: [f64; 2],
}

/// The signals of the block by name.
struct Signals {
    inputs: Shape,
    outputs: Shape,
}

impl Signals {
    fn output(&self, answers: &[Literal], name: &str) -> Option<f64> {
        Some(number(answers[self.outputs.place(name)?]))
    }

    /// Sets an input, if the block has it.
    fn set(&self, inputs: &mut [Literal], name: &str, value: f64) {
        if let Some(at) = self.inputs.place(name) {
            inputs[at] = literal(value, self.inputs.signals[at].ty, self.inputs.real);
        }
    }

    fn input(&self, inputs: &[Literal], name: &str) -> f64 {
        self.inputs.place(name).map_or(0.0, |at| number(inputs[at]))
    }
}

/// A velocity in range that no process data can hold [0.001 deg/s].
fn huge(real: RealKind) -> f64 {
    match real {
        RealKind::F64 => 1e14,
        RealKind::F32 => 9e8,
    }
}

impl<'a> Machinery<'a> {
    /// `None` if the block is not a spindle block.
    pub(super) fn of(designed: &'a Designed, block: &Block) -> Option<Self> {
        let spindle = designed.axis.control.spindle.as_ref()?;
        let shape = |variables| Shape::of(variables, designed.axis.real);
        let signals = Signals { inputs: shape(&block.program.inputs), outputs: shape(&block.program.outputs) };
        signals.inputs.place("drive_on")?;
        Some(Self {
            machine: Machine::start(&designed.axis, spindle, START).ok()?,
            step: engine::start(designed, block),
            answers: signals.outputs.signals.iter().map(|signal| signal.start).collect(),
            signals,
            operator: operator(&designed.axis, spindle),
            display: 0,
            is_on: false,
            feedforward: [0.0, 100.0],
        })
    }
}

impl Partner for Machinery<'_> {
    fn lead(&mut self, inputs: &mut [Literal]) {
        let Self { machine, signals, answers, operator, display, feedforward, .. } = self;
        let outputs = |name: &str| signals.output(answers, name);
        if self.is_on {
            machine.obey(&outputs, *feedforward);
        } else {
            machine.coast();
        }
        let seen = spindle_machine::seen(&outputs);
        let resets = operator.next(seen.state, outputs("waiting") == Some(0.0), outputs("fault") == Some(1.0));
        let Ok(commanded) = commanded(machine, seen) else { return };
        let actual = machine.actual;
        let is_near = shortest(commanded.x - actual.x).abs() <= WINDOW;
        *display = if operator.stuck > 0 { *display } else { actual.mode };
        let real = |of: Bad, value: f64| if operator.spoils(of) { f64::NAN } else { value };
        let v_interpolator =
            if operator.spoils(Bad::Huge) { huge(signals.inputs.real) } else { real(Bad::Interpolator, commanded.v) };
        let (x_actual, v_actual) = (real(Bad::Position, actual.x), real(Bad::Velocity, actual.v));
        let mut set = |name: &str, value: f64| signals.set(inputs, name, value);
        set("x_command", commanded.x);
        set("v_interpolator", v_interpolator);
        set("job_done", f64::from(u8::from(commanded.is_done && is_near)));
        set("x_actual", x_actual);
        set("v_actual", v_actual + operator.noise(300.0));
        set("v_motor", actual.v + operator.noise(3000.0));
        set("v_direct", actual.v + operator.noise(3000.0));
        set("operation_mode_display", f64::from(*display));
        set("drive_on", f64::from(u8::from(operator.off == 0)));
        set("reset", f64::from(u8::from(resets)));
        for request in REQUESTS {
            set(request, f64::from(u8::from(operator.asks_for(request))));
        }
        set("s_word", operator.speed);
        set("s_position", operator.target);
    }

    fn see(&mut self, inputs: &[Literal]) {
        self.is_on = self.signals.input(inputs, "drive_on") != 0.0;
        self.feedforward =
            ["feedforward_active", "feedforward_percentage"].map(|name| self.signals.input(inputs, name));
        (self.step)(inputs, &mut self.answers);
    }
}

/// The next command of the interpolator. After a fault the spindle may be faster than the start of any profile: the
/// interpolator then restarts at rest.
fn commanded(machine: &mut Machine<'_>, seen: Seen) -> Result<Commanded, Error> {
    machine.next(&seen).or_else(|_| {
        machine.restart(seen.x_spindle)?;
        machine.next(&Seen { v_spindle: 0.0, ..seen })
    })
}

/// The operator of a spindle: a slow speed is within position control, a fast one beyond it.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of cycles, which saturates")]
fn operator(axis: &Axis, spindle: &Spindle) -> Operator {
    let [on, off] = [spindle.v_velocity_control_on, spindle.v_position_control_on].map(f64::from);
    let largest = axis.ipc.v_max;
    let fast = if on > 0.0 { (1.5 * on).smaller(0.9 * largest) } else { 0.5 * largest };
    let slow = if off > 0.0 { (0.6 * off).smaller(0.5 * fast) } else { 0.1 * fast };
    Operator::of(slow, fast, (fast / spindle.deceleration / axis.cycle_time()) as u32)
}
