//! The block `axis`: feedforward, position control and improved position control in the order in which they need each other,
//! and which fault stops what.

use super::calls::Calls;
use super::coefficients::Coefficients;
use super::exact::Exact;
use super::feedforward::{Feedforward, is_in_range};
use super::history::Inputs;
use super::ipc::{self, Ipc};
use super::parameters::{Location, Parameters};
use super::position_control::{PositionControl, sent, x_drive};
use super::rounding::{Data, Expected, data, either, flag, id, real};

/// What it remembers.
#[derive(Clone, Debug)]
pub struct Axis {
    feedforward: Feedforward,
    control: PositionControl,
    ipc: Ipc,
    calls: Calls,
}

/// What the block put out, as far as the model goes on from it: each is compared before it is used.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// `x_drive` of the cycle before
    pub held: f64,
    /// `v_command` of this cycle, which SET_POINT reads
    pub v_command: f64,
    /// `v_add` of this cycle, which goes into the integers
    pub v_add: f64,
    /// `v_add_calculated` of this cycle
    pub calculated: f64,
    /// whether its error id is 3, the sum of the cycle before was a fault, or one that is told in its place
    pub is_disturbed: bool,
    /// its `tripped` of this cycle
    pub is_tripped: bool,
}

/// A spindle whose drive controls the position.
fn counts_turns(p: &Parameters, c: &Coefficients) -> bool {
    p.kind == SPINDLE && c.location != Location::Cnc
}

/// It turns by less than half a turn in a cycle: else 44.
fn half_turn(p: &Parameters, c: &Coefficients, inputs: &Inputs) -> u32 {
    let v = inputs.v_interpolator;
    let degrees = v.abs() * f64::from(p.cycle_ns) * 1e-9 / 1000.0;
    if counts_turns(p, c) && is_in_range(c, v) && degrees >= 180.0 { 44 } else { 0 }
}

/// P-AXIS-00018.
const SPINDLE: u32 = 4;

impl Axis {
    /// Before the first cycle.
    #[must_use]
    pub fn new(p: &Parameters, c: &Coefficients, sum_limit: f64) -> Self {
        Self {
            feedforward: Feedforward::default(),
            control: PositionControl::default(),
            ipc: Ipc::new(p, c, sum_limit),
            calls: Calls::default(),
        }
    }

    /// One cycle: what each output may be.
    pub fn cycle(&mut self, p: &Parameters, c: &Coefficients, inputs: &Inputs, found: Found) -> Expected {
        let calls = self.calls.call(p.counts_calls, inputs.cycle_counter);
        if calls.restarts {
            (self.feedforward, self.control) = (Feedforward::default(), PositionControl::default());
            self.ipc.stop();
        }
        let fault = PositionControl::fault(c, inputs, calls);
        let is_asked = fault == 0 && inputs.position_controlled && !inputs.reset;
        let turned = if is_asked { half_turn(p, c, inputs) } else { 0 };
        let acts = is_asked && turned == 0;
        let planned = self.feedforward.cycle(c, inputs, !acts);
        let controlled = match turned {
            _ if acts => self.control.act(c, inputs, &planned.v_feedforward),
            0 => self.control.stop(c, inputs),
            _ => self.control.hold(),
        };
        let command = ipc::command(c, inputs, found.v_command);
        if acts {
            self.ipc.decide(found.is_disturbed);
        }
        let is_tuning_held = acts && c.runs_stages && self.ipc.tune(inputs);
        self.ipc.rearm(inputs);
        let (ridden, command, held) =
            if acts && c.runs_stages { self.ipc.ride(p, c, inputs, command) } else { (*inputs, command, false) };
        let ipc_fault = match &c.slave {
            Some(_) if !is_in_range(c, inputs.v_add_master) => 22,
            Some(_) => 0,
            None if !acts => 0,
            None => self.ipc.fault(p, c, &ridden, command),
        };
        let added = match &c.slave {
            _ if !acts => self.ipc.rest(),
            _ if ipc_fault != 0 => self.ipc.stop(),
            Some(limit) => ipc::follow(c, limit, inputs.v_add_master),
            // In OFF the calculated value is 0, whatever the sum is.
            None if c.runs_stages => {
                let shown = if found.calculated == 0.0 { found.v_add } else { found.calculated };
                self.ipc.cycle(c, &ridden, command, shown, found.is_tripped)
            }
            None => ipc::NOTHING,
        };
        let v_add = if found.v_add.is_finite() { Exact::given(found.v_add) } else { Exact::zero() };
        let sent = sent(c, &controlled, &planned.v_additive, &v_add, acts);
        let torque: Data = data(&planned.torque, c.u, c.torque_bits.unwrap_or(32));
        let data_limited = [sent.manipulated, sent.xerr, sent.velocity, torque].map(|data| data.limited);
        // Of a part that is stopped nothing is told.
        let error_id = match (fault, planned.bad, ipc_fault) {
            (0, ..) if !acts => turned,
            (0, bad, 0) => bad,
            (0, _, of_ipc) => of_ipc,
            (fault, ..) => fault,
        };
        // Without that velocity half a turn would go unseen: this is an error, and the position goes on.
        let is_unseen = acts && counts_turns(p, c) && !is_in_range(c, inputs.v_interpolator);
        let error_id = if is_unseen { 14 } else { error_id };
        let is_fault = error_id != 0;
        let error_id = if error_id == 0 && is_tuning_held { 4 } else { error_id };
        let is_tripped = self.ipc.is_tripped();
        assert!(c.location == Location::Cnc || controlled.v_command.is_zero());
        vec![
            ("v_command", real(&controlled.v_command, c.u)),
            ("v_feedforward", real(&planned.v_feedforward, c.u)),
            ("v_add", added.v_add),
            ("v_add_calculated", added.calculated),
            ("x_drive", x_drive(c, &controlled, found.held)),
            ("manipulated_variable", sent.manipulated.value),
            ("xerr", sent.xerr.value),
            ("additive_torque", torque.value),
            ("additive_velocity", sent.velocity.value),
            ("error_id", id(if !is_fault && is_tripped { 5 } else { error_id })),
            ("limited", data_limited.into_iter().fold(added.limited, either)),
            ("held", flag(held)),
            ("tripped", flag(is_tripped)),
            ("fault", flag(is_fault)),
        ]
    }
}
