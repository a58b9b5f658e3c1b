//! What is explored: which drive, which letters, how many requests may wait. No search.

use super::drive::{IDEAL, Model, U, V_STEP};
use super::letters::{
    ACTUAL, BACKWARD, COASTING, DISPLAY, FEW_REQUESTS, INTERPOLATOR, Letter, OFF, OFF_AND_ASKED, QUIET, REFUSED,
    REQUESTS, RESET, RESETS, SAMPLES, is_request,
};
use super::world::World;
use machine::velocity::Follows;

/// An exploration.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// for messages
    pub name: String,
    /// position control in the drive
    pub in_drive: bool,
    /// the drive
    pub model: Model,
    /// Voff
    pub v_off: f64,
    /// deceleration * T
    pub v_step: f64,
    /// what can happen in a cycle
    pub letters: Vec<Letter>,
    /// how many requests may wait when another one comes
    pub waiting: u32,
    /// whether a request may come directly after another one
    pub is_dense: bool,
    /// whether states at different positions are different states
    pub is_absolute: bool,
    /// whether states after different transitions are different states: all pairs of transitions are seen then
    pub remembers: bool,
}

impl Scenario {
    /// Whether a letter can come in a state.
    #[must_use]
    pub fn allows(&self, world: &World, letter: Letter) -> bool {
        let was_request = world.held.contains(&true) && !world.is_first;
        !is_request(letter) || world.block.queued < self.waiting && (self.is_dense || !was_request)
    }
}

/// A quarter of the interpolator's acceleration.
const WEAK: Follows = Follows::Weak(U / 2.0);

fn scenario(name: &str, in_drive: bool, model: Model, letters: &[&[Letter]]) -> Scenario {
    Scenario {
        name: format!("{name}, position control in the {}", if in_drive { "drive" } else { "CNC" }),
        in_drive,
        model,
        v_off: U,
        v_step: V_STEP,
        letters: letters.iter().flat_map(|some| some.iter().copied()).collect(),
        waiting: 1,
        is_dense: false,
        is_absolute: false,
        remembers: false,
    }
}

/// All of them; `is_deep`: with more requests that wait, more letters, and positions told apart.
#[must_use]
pub fn all(is_deep: bool) -> Vec<Scenario> {
    let quiet: &[Letter] = &[QUIET, RESET];
    let few: &[&[Letter]] = &[quiet, &FEW_REQUESTS, &BACKWARD, &RESETS, &OFF, &SAMPLES, &INTERPOLATOR, &DISPLAY];
    let moving: &[&[Letter]] = &[quiet, &FEW_REQUESTS, &BACKWARD, &INTERPOLATOR];
    // What a drive that follows in its own way sees of the rest: the actual values, and the drive that is off.
    let following: &[&[Letter]] = &[moving[0], moving[1], moving[2], moving[3], &OFF[..2], &ACTUAL];
    let following = if is_deep { few } else { following };
    let asking: &[&[Letter]] = &[quiet, &REQUESTS, &BACKWARD, &REFUSED, &OFF, &INTERPOLATOR];
    let model = |answer, follows| Model { answer, follows, coasts: false };
    // The drive goes off and on at every speed that it reaches.
    let coasting: &[&[Letter]] = &[quiet, &FEW_REQUESTS, &BACKWARD[..1], &OFF[..4], &ACTUAL, &DISPLAY[..1], &COASTING];
    let mut all = Vec::new();
    for in_drive in [true, false] {
        all.push(Scenario { remembers: true, ..scenario("everything at once", in_drive, IDEAL, few) });
        all.push(scenario("every request", in_drive, IDEAL, asking));
        all.push(Scenario {
            waiting: 5,
            is_dense: true,
            ..scenario("a full queue", in_drive, IDEAL, &[quiet, &FEW_REQUESTS[..2], &OFF_AND_ASKED])
        });
        all.push(Scenario { v_off: 0.0, ..scenario("Voff 0", in_drive, IDEAL, few) });
        for follows in [Follows::Late, Follows::Beyond, WEAK, Follows::FromAbove(U, 2), Follows::FromAbove(U, 1)] {
            all.push(scenario(&format!("{follows:?}"), in_drive, model(Some(0), follows), following));
        }
        let weak = model(Some(0), WEAK);
        all.push(Scenario { v_step: U / 2.0, ..scenario("Weak, and a slow ramp", in_drive, weak, moving) });
    }
    for in_drive in [true, false] {
        for follows in [Follows::AtOnce, WEAK] {
            for answer in [Some(0), Some(1), Some(2), None] {
                let is_usual = follows == Follows::AtOnce || matches!(answer, Some(0) | None);
                if (is_deep || is_usual) && (in_drive || answer == Some(0)) {
                    let coasts = Model { answer, follows, coasts: true };
                    let name = format!("coasting, answer {answer:?}, {follows:?}");
                    let remembers = coasts == Model { coasts: true, ..IDEAL };
                    all.push(Scenario { remembers, ..scenario(&name, in_drive, coasts, coasting) });
                }
            }
        }
    }
    for answer in [Some(1), Some(2), None] {
        all.push(scenario(&format!("answer {answer:?}"), true, model(answer, Follows::AtOnce), few));
    }
    if is_deep {
        for one in &mut all {
            one.is_absolute = one.remembers && !one.model.coasts;
            one.waiting = if one.remembers { 1 } else { one.waiting.max(2) };
        }
    }
    all
}
