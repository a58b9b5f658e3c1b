//! A cycle of the block `ipc` that stands alone: which fault is told, which parameter set is in use. What the stages do is in
//! [`crate::model::ipc`].

use super::axes::Drawn;
use super::history::Given;
use super::set::{Checking, Set};
use crate::model::ipc::{Ipc, NOTHING};
use crate::model::rounding::{Expected, flag, id};
use std::rc::Rc;

/// What the block put out, as far as the model goes on from it: each is compared before it is used.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// `v_add` of this cycle; `v_add_calculated` where that is not 0
    pub shown: f64,
    /// whether the sum of the cycle before was a fault
    pub is_disturbed: bool,
    /// its `tripped` of this cycle
    pub is_tripped: bool,
}

/// A set that was refused.
#[derive(Clone, Copy, Debug)]
struct Refused {
    set: u32,
    why: u32,
    /// cycles until it is looked at again
    left: u32,
}

/// What it remembers.
#[derive(Clone, Debug)]
pub struct Alone<'d> {
    of: &'d Drawn,
    ipc: Ipc,
    /// the number of the set in use; 0: there is none
    in_use: u32,
    /// whether the block fades out for a set
    leaves: bool,
    refused: Option<Refused>,
    checking: Option<Checking>,
    /// the offered set as it was when its numbers were copied, until they have been checked
    copied: Option<Rc<Set>>,
}

impl<'d> Alone<'d> {
    /// Before the first cycle.
    #[must_use]
    pub fn new(of: &'d Drawn) -> Self {
        let ipc = Ipc::new(&of.parameters, &of.coefficients, of.sum_limit);
        Self { of, ipc, in_use: 0, leaves: false, refused: None, checking: None, copied: None }
    }

    /// Whether a set is in use.
    #[must_use]
    pub fn has_set(&self) -> bool {
        self.in_use != 0
    }

    /// Whether a bad sample would be ridden through, had the cycle before no fault.
    #[must_use]
    pub fn can_ride(&self) -> bool {
        self.ipc.can_ride()
    }

    /// One cycle: what each output may be.
    pub fn cycle(&mut self, given: &Given, found: Found) -> Expected {
        let (p, c) = (&self.of.parameters, &self.of.coefficients);
        let mut inputs = given.inputs;
        self.ipc.decide(found.is_disturbed);
        let takes_sets = p.tunable == "all";
        let refused = if takes_sets { self.look_at(&given.offered) } else { 0 };
        self.ipc.rearm(&inputs);
        if takes_sets && (0..=2).contains(&inputs.mode) {
            inputs.mode = match inputs.mode {
                _ if self.in_use == 0 => 0,
                1 if self.leaves => 2,
                mode => mode,
            };
        }
        let is_tuning_held = self.ipc.tune(&inputs);
        let (ridden, v_command, held) = self.ipc.ride(p, c, &inputs, given.v_command);
        let is_cycle_wrong = inputs.task_cycle_ns != 0 && inputs.task_cycle_ns != p.cycle_ns;
        let fault = match self.ipc.fault(p, c, &ridden, v_command) {
            bad @ 11..=13 => bad,
            _ if is_cycle_wrong => 1,
            0 if self.of.is_slave && inputs.mode != 0 => 70_600,
            other => other,
        };
        let acts = fault == 0 && inputs.position_controlled && !inputs.reset;
        let added = match acts {
            true => self.ipc.cycle(c, &ridden, v_command, found.shown, found.is_tripped),
            false => {
                self.ipc.stop();
                NOTHING
            }
        };
        let is_tripped = self.ipc.is_tripped();
        let error_id = match fault {
            0 if refused != 0 => refused,
            0 if is_tripped => 5,
            0 if is_tuning_held => 4,
            fault => fault,
        };
        let mut expected = vec![
            ("v_add", added.v_add),
            ("v_add_calculated", added.calculated),
            ("limited", added.limited),
            ("held", flag(held)),
            ("tripped", flag(is_tripped)),
            ("fault", flag(fault != 0 || refused != 0 && self.in_use == 0)),
            ("error_id", id(error_id)),
        ];
        if takes_sets {
            expected.push(("active_set", id(self.in_use)));
        }
        expected
    }

    /// What the block does with the set that is offered; why it is refused.
    fn look_at(&mut self, offered: &Rc<Set>) -> u32 {
        if self.ipc.is_disturbed() {
            (self.in_use, self.leaves, self.checking, self.copied) = (0, false, None, None);
            self.refused.iter_mut().for_each(|refused| refused.left = 0);
            return 0;
        }
        if self.in_use != 0 && offered.set_id == self.in_use {
            // Before the fade-out, the check of another set stays where it is.
            if std::mem::take(&mut self.leaves) {
                self.checking = None;
            }
            return 0;
        }
        if let Some(refused) = self.refused.as_mut().filter(|of| of.set == offered.set_id && of.left > 0) {
            refused.left -= 1;
            return refused.why;
        }
        let fades_out = self.ipc.is_open() && (self.leaves || self.ipc.is_tripped());
        let why = if fades_out { 0 } else { self.go_on(offered) };
        if why != 0 {
            self.refused = Some(Refused { set: offered.set_id, why, left: self.ipc.fade_cycles() });
            (self.leaves, self.checking, self.copied) = (false, None, None);
        }
        // While it is checked again, and during a fade-out, it stays refused.
        let same = self.refused.filter(|refused| refused.set == offered.set_id);
        same.map_or(why, |refused| refused.why)
    }

    /// The next step towards the use of a set: a piece of its check, the fade, the copy, a piece of the check of the copy;
    /// why it is refused.
    fn go_on(&mut self, offered: &Rc<Set>) -> u32 {
        let structure = &self.of.structure;
        let copied = self.copied.clone().filter(|copied| copied.set_id == offered.set_id && self.in_use == 0);
        let checking = self.checking.as_mut().filter(|checking| checking.set == offered.set_id && checking.set != 0);
        let Some(checking) = checking else {
            let begun = Checking::new(offered.set_id);
            let why = begun.begin(offered, structure);
            self.checking = Some(begun);
            return why;
        };
        if !checking.is_done(structure) {
            let numbers = &copied.as_ref().unwrap_or(offered).numbers;
            return checking.piece(numbers, structure, copied.is_some()).unwrap_or(0);
        }
        if let Some(copied) = copied {
            self.ipc.take(&self.of.filters[copied.of], copied.limits(structure));
            (self.in_use, self.leaves, self.copied) = (offered.set_id, false, None);
            return 0;
        }
        self.refused = None;
        if self.ipc.is_open() {
            self.leaves = true;
        } else {
            self.ipc.stop();
            (self.in_use, self.leaves, self.checking, self.copied) = (0, false, None, Some(Rc::clone(offered)));
        }
        0
    }
}
