//! The partner of a spindle: an operator who asks for every job, an interpolator, and a drive that is switched off, keeps its mode and loses
//! samples now and then. What it does depends on what the block puts out, and on nothing else.

use crate::engine::{self, Cycle};
use crate::samples::Shape;
use crate::scenario::grid::shortest;
use crate::scenario::interpolator::State;
use crate::scenario::machine::{self, Machine};
use crate::scenario::recorder::{literal, number};
use crate::stimulus::Partner;
use crate::waveform::Random;
use generator::axis::{Axis, Spindle};
use generator::blocks::{Block, Designed};
use portable::{Literal, RealKind};

/// Where the spindle stands at first [0.001 deg].
const START: f64 = 10_000.0;
/// How near the actual position is to the target, when a job is done [0.001 deg].
const WINDOW: f64 = 100.0;
/// Cycles for which a drive that is asked for another mode keeps its own, so that the block does not wait any longer.
const STUCK: u32 = 600;
/// Cycles for which a request is TRUE.
const REQUESTED: u32 = 2;
/// All inputs that ask for a job.
const REQUESTS: [&str; 6] = ["m3", "m4", "m5", "m19", "putax", "g74"];

/// An operator, an interpolator, a drive, and the reference of the block between them.
pub(super) struct Machinery<'a> {
    machine: Machine<'a>,
    step: Cycle,
    signals: Signals,
    answers: Vec<Literal>,
    operator: Operator,
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

    /// Sets an input; one that the block does not have is passed over.
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
    /// None, if the block is none of a spindle.
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
            operator: Operator::of(&designed.axis, spindle),
            is_on: false,
            feedforward: [0.0, 100.0],
        })
    }
}

impl Partner for Machinery<'_> {
    fn lead(&mut self, inputs: &mut [Literal]) {
        let Self { machine, signals, answers, operator, feedforward, .. } = self;
        let outputs = |name: &str| signals.output(answers, name);
        if self.is_on {
            machine.obey(&outputs, *feedforward);
        } else {
            machine.coast();
        }
        let mut seen = machine::seen(&outputs);
        let resets = operator.next(seen.state, outputs("waiting") == Some(0.0), outputs("fault") == Some(1.0));
        let commanded = machine.next(&seen).or_else(|_| {
            // After a fault the spindle may be faster than any profile begins.
            machine.restart(seen.x_spindle)?;
            seen.v_spindle = 0.0;
            machine.next(&seen)
        });
        let Ok(commanded) = commanded else { return };
        let actual = machine.actual;
        let is_near = shortest(commanded.x - actual.x).abs() <= WINDOW;
        let is_stuck = operator.stuck > 0;
        let display = if is_stuck { operator.display } else { actual.mode };
        operator.display = display;
        let is_bad = |of: Bad| operator.bad_for > 0 && operator.bad == of;
        let real = |of: Bad, value: f64| if is_bad(of) { f64::NAN } else { value };
        let v_interpolator =
            if is_bad(Bad::Huge) { huge(signals.inputs.real) } else { real(Bad::Interpolator, commanded.v) };
        let (x_actual, v_actual) = (real(Bad::Position, actual.x), real(Bad::Velocity, actual.v));
        let mut set = |name: &str, value: f64| signals.set(inputs, name, value);
        set("x_command", commanded.x);
        set("v_interpolator", v_interpolator);
        set("job_done", f64::from(u8::from(commanded.is_done && is_near)));
        set("x_actual", x_actual);
        set("v_actual", v_actual + operator.noise(300.0));
        set("v_motor", actual.v + operator.noise(3000.0));
        set("v_direct", actual.v + operator.noise(3000.0));
        set("operation_mode_display", f64::from(display));
        set("drive_on", f64::from(u8::from(operator.off == 0)));
        set("reset", f64::from(u8::from(resets)));
        for request in REQUESTS {
            set(request, f64::from(u8::from(operator.asks.contains(&request) && operator.asked > 0)));
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

/// Whoever asks for jobs, switches the drive and resets.
struct Operator {
    random: Random,
    /// speeds: slow and fast [0.001 deg/s]
    speeds: [f64; 3],
    /// cycles from 0 to the fastest of them
    ramp: u32,
    /// cycles until the next request
    pause: u32,
    /// cycles for which the present one is TRUE
    asked: u32,
    asks: &'static [&'static str],
    speed: f64,
    target: f64,
    /// cycles for which the drive is off
    off: u32,
    /// cycles for which the drive displays its mode as it is
    stuck: u32,
    display: i32,
    /// which sample is bad, and for how many cycles
    bad: Bad,
    bad_for: u32,
    /// how often each state has begun
    entries: [u32; 5],
    /// cycles for which a fault stands
    fault: u32,
    before: State,
}

/// A sample that is bad.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bad {
    /// the interpolator's velocity is far too large
    Huge,
    /// it is not a number
    Interpolator,
    /// the actual position is not a number
    Position,
    /// the actual velocity is not a number
    Velocity,
}

impl Operator {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of cycles, which saturates")]
    fn of(axis: &Axis, spindle: &Spindle) -> Self {
        let [on, off] = [spindle.v_velocity_control_on, spindle.v_position_control_on].map(f64::from);
        let largest = axis.ipc.v_max;
        let fast = if on > 0.0 { (1.5 * on).min(0.9 * largest) } else { 0.5 * largest };
        let slow = if off > 0.0 { (0.6 * off).min(0.5 * fast) } else { 0.1 * fast };
        Self {
            random: Random(0x9E37_79B9_7F4A_7C15),
            speeds: [slow, fast, fast],
            ramp: (fast / spindle.deceleration / axis.cycle_time()) as u32,
            pause: 60,
            asked: 0,
            asks: &[],
            speed: 0.0,
            target: 0.0,
            off: 3,
            stuck: 0,
            display: 0,
            bad: Bad::Huge,
            bad_for: 0,
            entries: [0; 5],
            fault: 0,
            before: State::ToPosition,
        }
    }

    /// A number below another one.
    fn below(&mut self, end: u32) -> u32 {
        (self.random.next() >> 32) as u32 % end.max(1)
    }

    /// Noise within a range, in steps of 1/32768 of it.
    fn noise(&mut self, range: f64) -> f64 {
        (f64::from(self.below(65_536)) / 32_768.0 - 1.0) * range
    }

    /// One cycle: what goes on counts down; a state that has just begun may be disturbed. Whether the operator resets.
    fn next(&mut self, state: State, nothing_waits: bool, has_fault: bool) -> bool {
        for left in [&mut self.off, &mut self.stuck, &mut self.asked, &mut self.bad_for] {
            *left = left.saturating_sub(1);
        }
        self.disturb(state);
        self.fault = if has_fault { self.fault + 1 } else { 0 };
        let resets = self.fault > 50 && self.below(100) == 0;
        self.pause = self.pause.saturating_sub(1);
        if self.pause == 0 && nothing_waits {
            self.ask();
            self.pause = 40 + self.below(self.ramp + 400);
        }
        self.before = state;
        resets
    }

    /// What goes wrong: each thing in each state, one after the other, where the state begins; now and then within it.
    fn disturb(&mut self, state: State) {
        let which = if state == self.before {
            self.below(20_000)
        } else {
            let entries = &mut self.entries[state as usize];
            *entries += 1;
            *entries % 12
        };
        match which {
            2 => self.off = 1 + self.below(40) * self.below(20),
            4 => (self.bad, self.bad_for) = (Bad::Huge, 1),
            5 => (self.bad, self.bad_for) = (Bad::Interpolator, 8),
            7 => self.stuck = STUCK,
            9 => (self.bad, self.bad_for) = (Bad::Position, 1 + self.below(8)),
            11 => (self.bad, self.bad_for) = (Bad::Velocity, 1 + self.below(8)),
            _ => {}
        }
    }

    /// The next request: every one of them, at every speed; now and then what no spindle can do.
    fn ask(&mut self) {
        const ASKED: [&[&str]; 12] = [
            &["m3"],
            &["m4"],
            &["m3"],
            &["m5"],
            &["m19", "m3"],
            &["m19", "m4"],
            &["putax"],
            &["g74"],
            &["m3"],
            &["m3", "m4"],
            &["m19", "m5"],
            &["m4"],
        ];
        self.asks = ASKED[self.below(12) as usize];
        self.asked = REQUESTED;
        self.speed = self.speeds[self.below(3) as usize];
        self.target = f64::from(self.below(360_000));
        match self.below(40) {
            0 => self.speed = f64::NAN,
            1 => self.target = f64::INFINITY,
            _ => {}
        }
    }
}
