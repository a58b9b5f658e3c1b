//! The block `position_control` in exact numbers: the controller of the CNC, or what a drive with the controller gets.

use super::calls::{Calls, Verdict};
use super::coefficients::Coefficients;
use super::exact::Exact;
use super::feedforward::{is_in_range, is_wrong_cycle};
use super::history::Inputs;
use super::parameters::{Location, Parameters};
use super::rounding::{Data, Expected, Interval, data, either, flag, id, real};
use std::collections::VecDeque;

/// What it remembers: the last position commands, the newest first.
#[derive(Clone, Debug, Default)]
pub struct PositionControl {
    commands: VecDeque<f64>,
}

/// What has been computed before `v_add` is known.
#[derive(Clone, Debug)]
pub struct Controlled {
    /// output of the controller with feedforward
    pub v_command: Exact,
    /// position command of the drive; `None`: it holds
    pub x_drive: Option<Exact>,
    /// control deviation
    pub xerr: Exact,
}

/// What goes to the drive once `v_add` is known.
#[derive(Clone, Copy, Debug)]
pub struct Sent {
    /// `manipulated_variable`
    pub manipulated: Data,
    /// `xerr`
    pub xerr: Data,
    /// `additive_velocity`
    pub velocity: Data,
}

impl PositionControl {
    /// 17, 1, 9, 18 or 24 in this order; 0: none of them.
    #[must_use]
    pub fn fault(c: &Coefficients, inputs: &Inputs, calls: Verdict) -> u32 {
        match () {
            () if !c.takes_following_error && !is_in_range(c, inputs.x_command) => 17,
            () if is_wrong_cycle(c, inputs) => 1,
            () if calls.is_fault => 9,
            () if c.takes_following_error => {
                if is_in_range(c, inputs.following_error) {
                    0
                } else {
                    24
                }
            }
            () if c.location != Location::Drive && !is_in_range(c, inputs.x_actual) => 18,
            () => 0,
        }
    }

    /// A cycle in which it does not act: `x_drive` follows the command, or holds where there is none.
    pub fn stop(&mut self, c: &Coefficients, inputs: &Inputs) -> Controlled {
        self.commands.clear();
        let has_command = c.takes_following_error || is_in_range(c, inputs.x_command);
        let follows = has_command.then(|| match c.location {
            Location::Cnc => Exact::zero(),
            Location::Drive | Location::Profidrive => Exact::given(inputs.x_command),
        });
        Controlled { v_command: Exact::zero(), x_drive: follows, xerr: Exact::zero() }
    }

    /// A cycle in which `x_drive` holds.
    pub fn hold(&mut self) -> Controlled {
        self.commands.clear();
        Controlled { v_command: Exact::zero(), x_drive: None, xerr: Exact::zero() }
    }

    /// A cycle in which it acts.
    pub fn act(&mut self, c: &Coefficients, inputs: &Inputs, v_feedforward: &Exact) -> Controlled {
        if self.commands.is_empty() {
            self.commands.extend(std::iter::repeat_n(inputs.x_command, c.shift + 1));
        }
        self.commands.pop_back();
        self.commands.push_front(inputs.x_command);
        let shifted = self.commands[c.shift];
        if c.location == Location::Cnc {
            let lag = if c.takes_following_error {
                Exact::given(inputs.following_error)
            } else {
                Exact::difference(inputs.x_command, inputs.x_actual)
            };
            let v_command = sum(c.kv.times(&lag), v_feedforward);
            return Controlled { v_command, x_drive: Some(Exact::zero()), xerr: Exact::zero() };
        }
        let lead = v_feedforward.over(&c.kv);
        let x_drive = sum(Exact::given(shifted), &lead);
        let xerr = match c.location {
            // Without a lead the subtraction is one of two inputs.
            Location::Profidrive if lead.is_zero() => c.increments.times(&Exact::difference(shifted, inputs.x_actual)),
            Location::Profidrive => c.increments.times(&x_drive.plus(&Exact::given(-inputs.x_actual))),
            Location::Cnc | Location::Drive => Exact::zero(),
        };
        Controlled { v_command: Exact::zero(), x_drive: Some(x_drive), xerr }
    }
}

/// What the drive gets. `acts` is false in a cycle whose integers are 0.
#[must_use]
pub fn sent(c: &Coefficients, controlled: &Controlled, v_additive: &Exact, v_add: &Exact, acts: bool) -> Sent {
    let none = data(&Exact::zero(), c.u, 32);
    if !acts {
        return Sent { manipulated: none, xerr: none, velocity: none };
    }
    let (scale, bits) = &c.manipulated;
    let (manipulated, into_velocity) = match c.location {
        Location::Cnc => {
            let v = sum(controlled.v_command.clone(), v_add);
            (data(&scale.times(&v), c.u, *bits), Exact::zero())
        }
        Location::Drive | Location::Profidrive => (none, v_add.clone()),
    };
    let velocity = c.velocity.as_ref().map_or(none, |(scale, bits)| {
        let v = sum(v_additive.clone(), &into_velocity);
        data(&scale.times(&v), c.u, *bits)
    });
    Sent { manipulated, xerr: data(&controlled.xerr, c.u, 32), velocity }
}

/// a + b, where adding nothing rounds nothing.
fn sum(a: Exact, b: &Exact) -> Exact {
    if b.is_zero() { a } else { a.plus(b) }
}

/// The interval of `x_drive`: what it is, or what it was.
#[must_use]
pub fn x_drive(c: &Coefficients, controlled: &Controlled, held: f64) -> Interval {
    controlled.x_drive.as_ref().map_or([held; 2], |x| real(x, c.u))
}

/// The block that stands alone.
#[derive(Clone, Debug, Default)]
pub struct Alone(PositionControl, Calls);

impl Alone {
    /// One cycle: what each output may be. `held` is the last `x_drive` that was put out.
    pub fn cycle(&mut self, p: &Parameters, c: &Coefficients, inputs: &Inputs, held: f64) -> Expected {
        let calls = self.1.call(p.counts_calls, inputs.cycle_counter);
        if calls.restarts {
            self.0 = PositionControl::default();
        }
        let reads_feedforward = c.conventional.iter().any(Option::is_some);
        let reads_additive = c.additive.iter().any(Option::is_some);
        let reads_v_add = c.has_v_add && (c.location == Location::Cnc || c.velocity.is_some());
        let read = [
            (reads_feedforward, inputs.v_feedforward, 19),
            (reads_additive, inputs.v_additive, 20),
            (reads_v_add, inputs.v_add, 21),
        ];
        let bad = || read.iter().find(|(is_read, value, _)| *is_read && !is_in_range(c, *value));
        let error_id = match PositionControl::fault(c, inputs, calls) {
            0 => bad().map_or(0, |(_, _, id)| *id),
            fault => fault,
        };
        let acts = error_id == 0 && inputs.position_controlled && !inputs.reset;
        let [v_feedforward, v_additive, v_add] =
            read.map(|(is_read, value, _)| if is_read && acts { Exact::given(value) } else { Exact::zero() });
        let controlled = if acts { self.0.act(c, inputs, &v_feedforward) } else { self.0.stop(c, inputs) };
        let sent = sent(c, &controlled, &v_additive, &v_add, acts);
        let torque = if acts && c.torque_bits.is_some() { f64::from(inputs.torque_feedforward) } else { 0.0 };
        vec![
            ("v_command", real(&controlled.v_command, c.u)),
            ("x_drive", x_drive(c, &controlled, held)),
            ("manipulated_variable", sent.manipulated.value),
            ("xerr", sent.xerr.value),
            ("additive_velocity", sent.velocity.value),
            ("additive_torque", [torque; 2]),
            ("limited", either(either(sent.manipulated.limited, sent.xerr.limited), sent.velocity.limited)),
            ("fault", flag(error_id != 0)),
            ("error_id", id(error_id)),
        ]
    }
}
