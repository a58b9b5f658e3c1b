//! Runs the program on a stimulus and says what is wrong: against the reference blocks, the schedule, and rules that hold in every cycle.

use super::project::Project;
use super::script::Row;
use super::world::{World, get, is};
use golden::engine::{Cycle, start};
use golden::samples::Shape;
use portable::Literal;
use st::Block;

/// A reference block: its inputs by name, its outputs by name.
struct Reference {
    cycle: Cycle,
    inputs: Shape,
    outputs: Shape,
    found: Vec<Literal>,
}

impl Reference {
    fn new(project: &Project, name: &str) -> Self {
        let block = project.emitted(name);
        let shape = |variables| Shape::of(variables, block.program.real);
        let (inputs, outputs) = (shape(&block.program.inputs), shape(&block.program.outputs));
        Self { cycle: start(&project.designed, &block), inputs, outputs, found: Vec::new() }
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

    fn real(&self, name: &str) -> f64 {
        if let Literal::F64(value) = self.output(name) { value } else { panic!("{name} is a real") }
    }
}

/// The same value; of reals the same bits.
fn same(a: Literal, b: Literal) -> bool {
    match (a, b) {
        (Literal::F64(a), Literal::F64(b)) => a.to_bits() == b.to_bits(),
        _ => a == b,
    }
}

/// What the drive gets: half away from zero, and no more than 32 bits with a sign.
#[expect(clippy::cast_possible_truncation, reason = "a number beyond is held at the end of the range")]
fn increments(v_add: f64, factor: f64) -> i32 {
    ((v_add * factor).round() as i32).max(-i32::MAX)
}

/// The first few things that are wrong.
pub fn violations(project: &Project, program: &Block, rows: &[Row]) -> Vec<String> {
    let (mut ipc, mut feedforward) = (Reference::new(project, "ipc"), Reference::new(project, "feedforward"));
    let mut run = program.start(&[], &[], &[]).unwrap();
    let (mut world, mut said, mut results, mut acting, mut before) =
        (World::default(), Vec::new(), Vec::new(), 0_u32, 0);
    for (at, row) in rows.iter().enumerate() {
        world.before(&mut run, row);
        run.cycle(&[], &mut results);
        let acts = row.state == 4;
        // In the cycle of a fault the block was still asked; a trip is acknowledged and comes back in one cycle.
        let asked = acts || row.state == 5 && (before == 4 || row.acknowledge || before == 3);
        acting = if acts { acting + 1 } else { 0 };
        before = row.state;
        let common = [
            ("position_controlled", Literal::Bool(asked)),
            ("reset", Literal::Bool(row.homing)),
            ("task_cycle_ns", Literal::U32(100 * row.cycle)),
        ];
        let [v_motor, mode] = [Literal::F64(1000.0 * row.velocity), Literal::I32(row.mode)];
        ipc.step(&[&common[..], &[("v_motor", v_motor), ("mode", mode)]].concat());
        let a_interpolator = Literal::F64(1000.0 * row.acceleration);
        let [active, percentage] = [Literal::Bool(row.feeds), Literal::I32(100)];
        let more = [
            ("a_interpolator", a_interpolator),
            ("feedforward_active", active),
            ("feedforward_percentage", percentage),
        ];
        feedforward.step(&[&common[..], &more].concat());

        let or_zero = |value: Literal| match value {
            _ if acts => value,
            Literal::Bool(_) => Literal::Bool(false),
            Literal::I32(_) => Literal::I32(0),
            _ => Literal::F64(0.0),
        };
        let limited = Literal::Bool(
            ipc.output("limited") == Literal::Bool(true) || feedforward.output("torque_limited") == Literal::Bool(true),
        );
        let fault = !matches!(row.state, 0 | 2 | 3 | 4);
        let offset = if acts { increments(ipc.real("v_add"), project.increments) } else { 0 };
        for (path, expected) in [
            ("GVL_axis_x.velocity_offset", Literal::I32(offset)),
            ("GVL_axis_x.torque_offset", or_zero(feedforward.output("additive_torque"))),
            ("GVL_axis_x.v_add", or_zero(Literal::F64(ipc.real("v_add") / 1000.0))),
            ("GVL_axis_x.v_add_calculated", or_zero(Literal::F64(ipc.real("v_add_calculated") / 1000.0))),
            ("GVL_axis_x.limited", or_zero(limited)),
            ("GVL_axis_x.held", or_zero(ipc.output("held"))),
            ("GVL_axis_x.state", Literal::I32(row.state)),
            ("GVL_axis_x.fault", Literal::Bool(fault)),
            ("GVL_axis_x.error_id", Literal::U32(row.error)),
            ("GVL_axis_x.nc_error_id", get(&run, "axis_x.NcToPlc.ErrorCode")),
            ("GVL_axis_x.acting_mode", or_zero(mode)),
        ] {
            let found = get(&run, path);
            if !same(found, expected) {
                said.push(format!("cycle {at}: {path} is {found:?}, expected {expected:?}; {row:?}"));
            }
        }
        rules(&run, (project, &world, row, acting), &mut |rule| said.push(format!("cycle {at}: {rule}; {row:?}")));
        if said.len() > 5 {
            break;
        }
    }
    said
}

/// What holds in every cycle, whatever the schedule says.
fn rules(
    run: &st::Instance<'_>,
    (project, world, row, acting): (&Project, &World, &Row, u32),
    say: &mut dyn FnMut(&str),
) {
    let Literal::I32(velocity) = get(run, "GVL_axis_x.velocity_offset") else { panic!("60B1h is a DINT") };
    let Literal::I32(torque) = get(run, "GVL_axis_x.torque_offset") else { panic!("60B2h is an INT") };
    if (velocity, torque) != (0, 0) {
        if !(row.enable && world.operates) {
            say("an offset without power");
        }
        if is(run, "GVL_axis_x.fault") {
            say("an offset beside a fault");
        }
    }
    // The fade has 100 steps from 0 on, whatever the axis does: at enabling, after a trip, after the self-test.
    let largest = 25_000.0 * project.increments * f64::from(acting.saturating_sub(1)) / 100.0 + 0.5;
    if f64::from(velocity).abs() > largest {
        say("a jump at enabling");
    }
    let power = ["stub_enable", "stub_enable_positive", "stub_enable_negative"];
    let power = power.map(|name| is(run, &format!("axis_x.PlcToNc.{name}")));
    if power != [row.enable && row.state != 6; 3] {
        say("power although it is off or tripped, or none although it is on");
    }
    if row.enable && is(run, "axis_x.PlcToNc.stub_restart") {
        say("a reset of the NC while the axis is wanted under power");
    }
    if get(run, "axis_x.PlcToNc.stub_override") != Literal::F64(100.0) {
        say("another override");
    }
}
