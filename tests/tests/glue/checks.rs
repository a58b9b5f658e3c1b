//! Runs the program on the lives of both axes and says what is wrong: against the reference blocks, what has to be
//! seen, and rules that hold in every cycle.

use super::project::{Axis, Project};
use super::script::Row;
use super::world::{self, get};
use golden::engine::{Cycle, start};
use golden::samples::Shape;
use portable::Literal;
use st::{Block, Instance};

/// Cycles of a fade.
const FADE: f64 = 100.0;
/// What is too small for an increment [um/s]: the rounding of a velocity.
const ROUNDING: f64 = 1.0e-6;

/// A reference block: its inputs by name, its outputs by name.
struct Reference {
    cycle: Cycle,
    inputs: Shape,
    outputs: Shape,
    found: Vec<Literal>,
}

impl Reference {
    fn new(axis: &Axis, name: &str) -> Self {
        let block = axis.emitted(name);
        let shape = |variables| Shape::of(variables, block.program.real);
        let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
        Self { cycle: start(&axis.designed, &block), inputs, outputs, found: Vec::new() }
    }

    fn step(&mut self, given: &[(&str, Literal)]) {
        let value = |name: &str| given.iter().find(|(own, _)| *own == name).map(|(_, value)| *value);
        let values: Vec<Literal> =
            self.inputs.signals.iter().map(|signal| value(&signal.name).unwrap_or(signal.start)).collect();
        (self.cycle)(&values, &mut self.found);
    }

    fn output(&self, name: &str) -> Literal {
        let at = self.outputs.signals.iter().position(|signal| signal.name == name);
        self.found[at.unwrap_or_else(|| panic!("the reference has no output {name}"))]
    }

    fn is(&self, name: &str) -> bool {
        self.output(name) == Literal::Bool(true)
    }

    fn real(&self, name: &str) -> f64 {
        if let Literal::F64(value) = self.output(name) { value } else { panic!("{name} is a real") }
    }
}

/// The same value; of reals the same bits.
fn same(a: Literal, b: Literal) -> bool {
    match (a, b) {
        (Literal::F64(a), Literal::F64(b)) => a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan(),
        _ => a == b,
    }
}

/// What the drive gets: half away from zero, and no more than 32 bits with a sign.
#[expect(clippy::cast_possible_truncation, reason = "a number beyond is held at the end of the range")]
fn increments(v_add: f64, factor: f64) -> i32 {
    ((v_add * factor).round() as i32).max(-i32::MAX)
}

/// What is known of an axis from cycle to cycle.
struct Course<'p> {
    axis: &'p Axis,
    ipc: Reference,
    feedforward: Reference,
    /// the last good velocity after the filter, and what the filter holds back [mm/s]
    before: Option<f64>,
    lead: f64,
    was_good: bool,
    was_known: bool,
    /// cycles since v_add had to be 0 at once
    since: u32,
    /// cycles since it began to fade out
    paused: u32,
    /// v_add and v_add_calculated of the cycle before [um/s]
    last: [f64; 2],
}

impl<'p> Course<'p> {
    fn new(axis: &'p Axis) -> Self {
        let [ipc, feedforward] = ["ipc", "feedforward"].map(|name| Reference::new(axis, name));
        let (was_good, was_known) = (false, false);
        Self {
            axis,
            ipc,
            feedforward,
            before: None,
            lead: 0.0,
            was_good,
            was_known,
            since: 0,
            paused: 0,
            last: [0.0; 2],
        }
    }

    /// The motor's velocity as it comes out of the NC's filter [um/s].
    fn motor(&mut self, row: &Row) -> f64 {
        let is_good = row.velocity.is_finite();
        if is_good {
            if let Some(before) = self.before.filter(|_| self.was_good) {
                self.lead = self.axis.filter_cycles * (row.velocity - before);
            }
            self.before = Some(row.velocity);
        }
        self.was_good = is_good;
        1000.0 * (row.velocity + self.lead)
    }

    /// One cycle of the reference blocks. They are asked by the words of docs/twincat.md.
    fn step(&mut self, row: &Row, count: u32) {
        let is_tested = !matches!(row.state, 0 | 1);
        let stands = row.set_velocity.abs() <= 0.001;
        let is_paused = row.setup || row.state == 5 || stands && (row.hold || row.percentage == 0);
        let mode = match row.mode {
            _ if !is_tested => 0,
            1 if is_paused => 2,
            mode => mode,
        };
        let common = [
            ("position_controlled", Literal::Bool(is_tested && controlled(row))),
            ("reset", Literal::Bool(row.stop || row.homing)),
            ("task_cycle_ns", Literal::U32(100 * row.cycle)),
            ("cycle_counter", Literal::U32(count)),
        ];
        let v_motor = self.motor(row);
        self.ipc.step(&[&common[..], &[("v_motor", Literal::F64(v_motor)), ("mode", Literal::I32(mode))]].concat());
        let more = [
            ("a_interpolator", Literal::F64(1000.0 * row.acceleration)),
            ("feedforward_active", Literal::Bool(row.feeds)),
            ("feedforward_percentage", Literal::I32(100)),
        ];
        self.feedforward.step(&[&common[..], &more].concat());
    }

    /// What the list of the axis holds after the cycle.
    fn expected(&self, row: &Row) -> Vec<(&'static str, Literal)> {
        let Literal::I32(torque) = self.feedforward.output("additive_torque") else { panic!("a torque is an integer") };
        let sign = if self.axis.inverted { -1 } else { 1 };
        let torque = (sign * (torque + row.weight)).clamp(-32_767, 32_767);
        let increments = increments(self.ipc.real("v_add"), f64::from(sign) * self.axis.increments);
        let is_paused = row.setup || row.state == 5;
        let stands = row.set_velocity.abs() <= 0.001 && (row.hold || row.percentage == 0);
        vec![
            ("velocity_offset", Literal::I32(increments)),
            ("torque_offset", Literal::I32(torque)),
            ("v_add", Literal::F64(self.ipc.real("v_add") / 1000.0)),
            ("v_add_calculated", Literal::F64(self.ipc.real("v_add_calculated") / 1000.0)),
            ("limited", Literal::Bool(self.ipc.is("limited") || self.feedforward.is("torque_limited"))),
            ("held", self.ipc.output("held")),
            ("state", Literal::I32(row.state)),
            ("acting_mode", Literal::I32(if row.mode == 1 && (is_paused || stands) { 2 } else { row.mode })),
            ("fault", Literal::Bool(matches!(row.state, 1 | 5))),
            ("error_id", Literal::U32(row.error)),
        ]
    }

    /// What holds in every cycle, whatever is asked for.
    fn rules(&mut self, run: &Instance<'_>, row: &Row, say: &mut dyn FnMut(&str)) {
        let letter = self.axis.letter;
        let list = |name: &str| get(run, &format!("GVL_axis_{letter}.{name}"));
        let (Literal::I32(offset), Literal::I32(torque)) = (list("velocity_offset"), list("torque_offset")) else {
            panic!("offsets are integers")
        };
        let (Literal::F64(shown), Literal::F64(calculated)) = (list("v_motor"), list("v_add_calculated")) else {
            panic!("velocities are reals")
        };
        // In the unit of the blocks and in the direction of the axis: by the drive's own number, not by what is shown.
        let sign = if self.axis.inverted { -1.0 } else { 1.0 };
        let v_add = sign * f64::from(offset) / self.axis.increments;
        let (rounding, limit) = (0.5 / self.axis.increments + ROUNDING, self.axis.limit());
        let at_once = row.state <= 3 || self.ipc.is("fault") || row.missing >= 3;
        // After a pause the block presets its filters in the same cycle, else in the next one.
        self.since = if at_once { u32::from(row.missing >= 3) } else { self.since + 1 };
        self.paused = if matches!(row.state, 5 | 6) { self.paused + 1 } else { 0 };
        if at_once && offset != 0 {
            say("a velocity offset that shall be 0 at once");
        }
        if self.since > 0 && v_add.abs() > limit * f64::from(self.since - 1) / FADE + rounding {
            say("a jump where it begins");
        }
        if f64::from(self.paused) > FADE && offset != 0 {
            say("a velocity offset after the fade");
        }
        let calculated = 1000.0 * calculated;
        let [last, last_calculated] = self.last;
        let largest = limit / FADE + (calculated - last_calculated).abs() + 2.0 * rounding;
        if !at_once && row.mode != 0 && (v_add - last).abs() > largest {
            say("a step above that of the fade");
        }
        self.last = [v_add, calculated];
        let weight = sign * f64::from(row.weight);
        if !(row.feeds || (f64::from(torque) - weight).abs() < 2.0) {
            say("another torque than the weight's");
        }
        // The inverse of the NC's filter gives the motor's velocity, but for the roundings of both.
        let is_known = row.velocity.is_finite() && (self.was_known || self.axis.filter_cycles == 0.0);
        if is_known && (shown - row.motor).abs() > 1.0e-9 {
            say("another velocity than the motor's");
        }
        self.was_known = row.velocity.is_finite();
        if get(run, &format!("axis_{letter}.PlcToNc.Override")) != Literal::U32(row.percentage) {
            say("another override");
        }
    }
}

/// Whether NC, drive and brake leave the axis to its position control.
fn controlled(row: &Row) -> bool {
    row.operational && row.closed && row.nc_error == 0 && row.drive & 0x6F == 0x27 && !row.brake_closed
}

/// The first few things that are wrong.
pub fn violations(project: &Project, program: &Block, lives: &[Vec<Row>; 2]) -> Vec<String> {
    let mut run = program.start(&[], &[], &[]).unwrap();
    let mut courses = project.axes.each_ref().map(Course::new);
    let (mut said, mut results, mut count) = (Vec::new(), Vec::new(), 1000_u32);
    for at in 0..lives[0].len() {
        count += 1 + lives[0][at].missing;
        world::task(&mut run, lives[0][at].cycle, count);
        for (course, life) in courses.iter().zip(lives) {
            world::axis(&mut run, course.axis.letter, &life[at]);
        }
        run.cycle(&[], &mut results);
        for (course, life) in courses.iter_mut().zip(lives) {
            let row = &life[at];
            course.step(row, count);
            let letter = course.axis.letter;
            for (name, expected) in course.expected(row) {
                let found = get(&run, &format!("GVL_axis_{letter}.{name}"));
                if !same(found, expected) {
                    said.push(format!("cycle {at}: {letter}.{name} is {found:?}, expected {expected:?}; {row:?}"));
                }
            }
            course.rules(&run, row, &mut |rule| said.push(format!("cycle {at}: {letter}: {rule}; {row:?}")));
        }
        if said.len() > 5 {
            break;
        }
    }
    said
}
